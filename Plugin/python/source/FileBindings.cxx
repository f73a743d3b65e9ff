// SPDX-License-Identifier: GPL-3.0-or-later
// NUAGES files, curve networks and boundary representations for Python.
#include "BRep/BRepContours.h"
#include "BRep/BRepFormatter.h"
#include "BRep/BRepParser.h"
#include "Common/ClosedLoops.h"
#include "CurveNetwork/CurveNetworkParser.h"
#include "GivenData.h"
#include "NUAGES/NUAGESFormatter.h"
#include "NUAGES/NUAGESParser.h"
#include "PythonMonitor.h"

namespace recon
{
namespace
{
/// What a file of this content is: "NUAGES", "CurveNetwork", "BRep" or empty.
std::string FormatOf(const std::string& fileName)
{
  if (IsNUAGES(fileName))
  {
    return "NUAGES";
  }
  if (CurveNetworkFormatOf(fileName) != CurveNetworkFormat::None)
  {
    return "CurveNetwork";
  }
  return IsBRep(fileName) ? "BRep" : "";
}

nb::dict ReadNUAGESFile(const std::string& fileName, nb::handle progress)
{
  const ContourFile file =
    RunWithoutLock(progress, [&](Monitor& monitor) { return ReadNUAGES(fileName, monitor); });
  std::vector<int> order;
  nb::dict result = FromSoup(file.Soup, order);
  result["report"] = ToList(file.Report);
  return result;
}

std::vector<std::string> WriteLoops(
  const std::string& fileName, LoopSoup soup, const std::vector<int>& depths, Monitor& monitor)
{
  int looseVertices = 0;
  LoopSoup closed = CloseLoops(std::move(soup), "NUAGES files hold", looseVertices, monitor);
  if (closed.Chains.empty())
  {
    throw Error("There are no closed contours to write.");
  }
  std::vector<std::string> report;
  if (looseVertices > 0)
  {
    report.push_back(std::to_string(looseVertices) + " loose vertices are no contours; left out.");
  }
  OrientByDepth(depths, closed);
  const std::vector<std::string> moved = WriteNUAGES(fileName, closed, monitor);
  report.insert(report.end(), moved.begin(), moved.end());
  return report;
}

nb::list WriteNUAGESFile(
  const std::string& fileName, const nb::dict& loops, nb::handle depths, nb::handle progress)
{
  const LoopSoup soup = SoupOf(loops);
  std::vector<int> given;
  if (!depths.is_none())
  {
    given = ToVector<int>(nb::cast<GivenValues<int>>(depths));
  }
  return ToList(RunWithoutLock(
    progress, [&](Monitor& monitor) { return WriteLoops(fileName, soup, given, monitor); }));
}

nb::dict ReadCurveNetworkFile(const std::string& fileName, nb::handle progress)
{
  const CurveNetwork network =
    RunWithoutLock(progress, [&](Monitor& monitor) { return ReadCurveNetwork(fileName, monitor); });
  if (network.Materials.empty())
  {
    throw Error("Cannot read " + fileName + ": it has no contours.");
  }
  nb::list materials;
  for (const MaterialContours& material : network.Materials)
  {
    std::vector<int> order;
    nb::dict contours = FromSoup(material.Soup, order);
    nb::dict cells;
    cells["Plane"] = ArrayOf(order, [&](int chain) { return material.Planes[chain]; });
    contours["cell_data"] = cells;
    nb::dict field;
    field["Material"] = material.Label;
    contours["field_data"] = field;
    materials.append(contours);
  }
  nb::dict result;
  result["materials"] = materials;
  result["report"] = ToList(network.Report);
  return result;
}

/// The contours of a boundary representation, loops of the surface's own points.
nb::dict ContoursOf(const ShelledMesh& shells)
{
  LoopSoup soup;
  soup.Points = shells.Mesh.Points;
  for (const std::vector<int>& contour : shells.Contours)
  {
    LoopSoup::Chain chain;
    chain.Points = contour;
    chain.Closed = true;
    soup.Chains.push_back(std::move(chain));
  }
  std::vector<int> order;
  nb::dict contours = FromSoup(soup, order);
  nb::dict cells;
  cells["ShellId"] = ToNumpy(shells.ShellOfContour);
  cells["ShellSet"] = ToNumpy(shells.ShellSetOfContour);
  contours["cell_data"] = cells;
  return contours;
}

nb::dict ReadBRepFile(const std::string& fileName, nb::handle progress)
{
  ShelledMesh shells = RunWithoutLock(
    progress, [&](Monitor& monitor) { return MakeMesh(ReadBRep(fileName, monitor)); });
  nb::dict result;
  result["contours"] = ContoursOf(shells);
  nb::dict cells;
  cells["ShellId"] = ToNumpy(std::move(shells.ShellOfTriangle));
  cells["ShellSet"] = ToNumpy(std::move(shells.ShellSetOfTriangle));
  nb::dict surface;
  surface["points"] = ToNumpy(std::move(shells.Mesh.Points));
  surface["triangles"] = ToNumpy(std::move(shells.Mesh.Triangles));
  surface["cell_data"] = cells;
  result["surface"] = surface;
  return result;
}

nb::list WriteBRepFile(const std::string& fileName, const GivenPoints& points,
  const GivenTriangles& triangles, nb::handle shellSets, nb::handle contours, nb::handle progress)
{
  const TriangleMesh mesh = MeshOf(points, triangles);
  const LoopSoup soup = contours.is_none() ? LoopSoup() : SoupOf(nb::borrow<nb::dict>(contours));
  std::vector<int> sets;
  if (!shellSets.is_none())
  {
    sets = ToVector<int>(nb::cast<GivenValues<int>>(shellSets));
  }
  return ToList(RunWithoutLock(progress,
    [&](Monitor& monitor)
    {
      const std::vector<SpaceLoop> loops = ClosedSpaceLoops(soup, monitor);
      std::vector<int> missing;
      const BRep brep = MakeBRep(mesh, sets, loops, missing, monitor);
      WriteBRep(fileName, brep, monitor);
      std::vector<std::string> report;
      if (!missing.empty())
      {
        report.push_back(std::to_string(missing.size()) + " of " + std::to_string(loops.size()) +
          " contours (the first is number " + std::to_string(missing.front()) +
          ") do not run along edges of the surface and were left out.");
      }
      return report;
    }));
}
}

void BindFiles(nb::module_& module)
{
  module.def("format_of", &FormatOf, nb::arg("file_name"));
  module.def("read_nuages", &ReadNUAGESFile, nb::arg("file_name"), nb::arg("progress").none());
  module.def("write_nuages", &WriteNUAGESFile, nb::arg("file_name"), nb::arg("loops"),
    nb::arg("depths").none(), nb::arg("progress").none());
  module.def(
    "read_curve_network", &ReadCurveNetworkFile, nb::arg("file_name"), nb::arg("progress").none());
  module.def("read_brep", &ReadBRepFile, nb::arg("file_name"), nb::arg("progress").none());
  module.def("write_brep", &WriteBRepFile, nb::arg("file_name"), nb::arg("points"),
    nb::arg("triangles"), nb::arg("shell_sets").none(), nb::arg("contours").none(),
    nb::arg("progress").none());
}
}
