// SPDX-License-Identifier: GPL-3.0-or-later
// Polyhedral Surface, Fair Surface, Implicit Surface, Implicit Contours and Surface Certificate for Python.
#include "Base/SubMonitor.h"
#include "Contours/Specks.h"
#include "Fair/FairSurface.h"
#include "GivenData.h"
#include "Implicit/ZeroSet/ContourTracer.h"
#include "Mesh/CertificateText.h"
#include "Polyhedral/LeftOut.h"
#include "Polyhedral/PolyhedralSurface.h"
#include "PythonMonitor.h"

#include <algorithm>
#include <limits>

namespace recon
{
namespace
{
/// Contours as they were read, and what was made of them.
template <typename Result>
struct Made
{
  ContourSet Contours;
  std::vector<std::string> Report; ///< what came with the contours, in the order of the nodes
  Result Output;
};

nb::dict FromMesh(TriangleMesh mesh)
{
  nb::dict surface;
  surface["points"] = ToNumpy(std::move(mesh.Points));
  surface["triangles"] = ToNumpy(std::move(mesh.Triangles));
  return surface;
}

void AddReport(std::vector<std::string> report, const std::vector<std::string>& more,
  const std::string& warning, nb::dict& result)
{
  report.insert(report.end(), more.begin(), more.end());
  result["report"] = ToList(report);
  result["warning"] = warning;
}

/// What surfaces over joins have in common.
template <typename Surface, typename Count>
nb::dict FieldsOf(const Made<Surface>& made, Count leftOut)
{
  nb::dict field = LevelsOf(made.Contours);
  field["ContourCount"] = made.Contours.Contours.size();
  field["LeftOutCount"] = leftOut;
  field["EndCapVolume"] = made.Output.EndCapVolume;
  field["IsolatedVolume"] = made.Output.IsolatedVolume;
  return field;
}

nb::dict FromPolyhedral(Made<PolyhedralSurface> made)
{
  PolyhedralSurface& surface = made.Output;
  nb::dict field = FieldsOf(made, CountLeftOut(made.Contours, surface.Mesh));
  nb::dict cells;
  cells["Slab"] = ToNumpy(std::move(surface.Slab));
  cells["FaceKind"] = ToNumpy(std::move(surface.FaceKind));
  cells["MappingGroup"] = ToNumpy(std::move(surface.MappingGroup));
  cells["Piece"] = ToNumpy(std::move(surface.Piece));
  nb::dict points;
  points["PointKind"] = ToNumpy(std::move(surface.PointKind));
  nb::dict result = FromMesh(std::move(surface.Mesh));
  result["cell_data"] = cells;
  result["point_data"] = points;
  result["field_data"] = field;
  AddReport(std::move(made.Report), {}, made.Contours.Warning, result);
  return result;
}

nb::dict FromFair(Made<FairSurface> made)
{
  FairSurface& surface = made.Output;
  nb::dict field = FieldsOf(made, surface.LeftOut);
  field["Tolerance"] = surface.Tolerance;
  field["EdgeLength"] = surface.EdgeLength;
  field["Tension"] = surface.Tension;
  field["FarthestVertex"] = surface.Farthest;
  field["BeyondTolerance"] = surface.Beyond;
  field["ThinTriangles"] = surface.Thin;
  field["HeldBackPoints"] = surface.HeldBack;
  nb::dict result = FromMesh(std::move(surface.Mesh));
  result["cell_data"] = nb::dict();
  result["point_data"] = nb::dict();
  result["field_data"] = field;
  AddReport(std::move(made.Report), {}, made.Contours.Warning, result);
  return result;
}

/// A surface over joins that the properties, or a mapping that the contours carry, may ask for.
/// @param build (contours, what is joined to what, monitor) -> the surface
template <typename Surface, typename Build>
Made<Surface> OverJoins(
  const nb::dict& loops, const nb::dict& properties, nb::handle progress, const Build& build)
{
  const LoopSoup soup = SoupOf(loops);
  const ContourSetOptions reading = ContourSetOptionsOf(properties, true);
  const std::optional<CarriedMapping> carried = CarriedMappingOf(loops);
  PolyhedralOptions options = PolyhedralOptionsOf(properties);
  ContourMappingOptions joins;
  joins.ForcedJoins = PairsOf(properties, "ForcedJoins");
  joins.ForbiddenJoins = PairsOf(properties, "ForbiddenJoins");
  return RunWithoutLock(progress,
    [&](Monitor& monitor)
    {
      SubMonitor cleaning(monitor, 0.0, 0.1);
      SubMonitor building(monitor, 0.1, 1.0);
      Made<Surface> made;
      made.Contours = BuildContourSet(soup, reading, cleaning);
      made.Report = made.Contours.Report;
      if (carried)
      {
        made.Report.push_back(FollowMapping(*carried, made.Contours, joins));
      }
      options.ForcedJoins = joins.ForcedJoins;
      options.ForbiddenJoins = joins.ForbiddenJoins;
      made.Output = build(made.Contours, options, building);
      std::vector<std::string>& report = made.Report;
      report.insert(report.end(), made.Output.Report.begin(), made.Output.Report.end());
      CheckNotEmpty(made.Output.Mesh, report);
      return made;
    });
}

nb::dict Polyhedral(const nb::dict& loops, const nb::dict& properties, nb::handle progress)
{
  return FromPolyhedral(OverJoins<PolyhedralSurface>(loops, properties, progress,
    [](const ContourSet& contours, PolyhedralOptions options, Monitor& monitor)
    { return BuildPolyhedralSurface(contours, options, monitor); }));
}

nb::dict Fair(const nb::dict& loops, const nb::dict& properties, nb::handle progress)
{
  FairOptions fair;
  fair.Tolerance = nb::cast<double>(properties["Tolerance"]);
  fair.EdgeLength = nb::cast<double>(properties["EdgeLength"]);
  fair.Tension = nb::cast<double>(properties["Tension"]);
  return FromFair(OverJoins<FairSurface>(loops, properties, progress,
    [&](const ContourSet& contours, PolyhedralOptions options, Monitor& monitor)
    {
      options.PinchGap = FairPinchGap;
      fair.Polyhedral = options;
      fair.Threads = options.Threads;
      return BuildFairSurface(contours, fair, monitor);
    }));
}

nb::dict Implicit(const nb::dict& loops, const nb::dict& properties, nb::handle progress)
{
  const LoopSoup soup = SoupOf(loops);
  const ContourSetOptions reading = ContourSetOptionsOf(properties, false);
  const ImplicitSurfaceOptions options = ImplicitSurfaceOptionsOf(properties);
  Made<ImplicitSurface> made = RunWithoutLock(progress,
    [&](Monitor& monitor)
    {
      SubMonitor cleaning(monitor, 0.0, 0.05);
      SubMonitor building(monitor, 0.05, 1.0);
      Made<ImplicitSurface> result;
      result.Contours = BuildContourSet(soup, reading, cleaning);
      result.Output = BuildImplicitSurface(result.Contours, options, building);
      return result;
    });
  ImplicitSurface& surface = made.Output;
  nb::dict field;
  field["CellSize"] = surface.Mesh.CellSize;
  field["SmallestAngle"] = surface.Mesh.SmallestAngle;
  field["FarContourPoints"] = surface.Mesh.FarContourPoints;
  field["Residual"] = surface.Fit.Function.Residual;
  field["MarginDistance"] = surface.Fit.Constraints.MarginDistance;
  field["ConstraintCount"] = surface.Fit.Function.Centres.size();
  nb::dict points;
  points["Normals"] = ToNumpy(std::move(surface.Mesh.Normals));
  nb::dict result = FromMesh(std::move(surface.Mesh.Mesh));
  result["point_data"] = points;
  result["cell_data"] = nb::dict();
  result["field_data"] = field;
  AddReport(std::move(surface.Report), {}, made.Contours.Warning, result);
  return result;
}

/// Planes that were given by normal and offset.
std::vector<TracePlane> GivenPlanes(nb::handle given)
{
  std::vector<TracePlane> planes;
  for (const nb::handle plane : given)
  {
    const Vector3 normal{ nb::cast<double>(plane[0]), nb::cast<double>(plane[1]),
      nb::cast<double>(plane[2]) };
    planes.push_back({ FrameAbout(normal), nb::cast<double>(plane[3]) });
  }
  return planes;
}

/// What contours_on_planes was asked, in the core's words.
struct TracingTask
{
  LoopSoup Soup;
  ContourSetOptions Reading;
  ConstraintOptions Constraints;
  FunctionOptions Function;
  TracerOptions Tracer;
  std::optional<std::vector<TracePlane>> Planes;
  std::optional<LoopSoup> PlanesOfLoops;
  Vector3 Normal{};
  std::optional<std::array<double, 2>> Range;
  double Spacing = 0;
  bool Extrapolate = false;
  double SmallestArea = 0;
  double PixelArea = 0;            ///< of the images that the planes are of, or 0
  std::optional<double> Tolerance; ///< of the given planes
};

TracingTask TracingTaskOf(const nb::dict& loops, nb::handle planes, const nb::dict& properties)
{
  TracingTask task;
  task.Soup = SoupOf(loops);
  task.Reading = ContourSetOptionsOf(properties, false);
  task.Constraints = ConstraintOptionsOf(properties);
  task.Function = FunctionOptionsOf(properties);
  task.Tracer.CellSize = ValueOf<double>(properties, "CellSize");
  task.Tracer.Box = BoundsOf(properties);
  task.Tracer.MaximumCells = ValueOf<double>(properties, "MaximumCells");
  task.Tracer.Threads = task.Function.Threads;
  if (nb::isinstance<nb::dict>(planes))
  {
    task.PlanesOfLoops = SoupOf(nb::borrow<nb::dict>(planes));
  }
  else if (!planes.is_none())
  {
    task.Planes = GivenPlanes(planes);
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    task.Normal[i] = nb::cast<double>(properties["PlaneNormal"][i]);
  }
  if (ValueOf<bool>(properties, "UseRange"))
  {
    task.Range = { nb::cast<double>(properties["Range"][0]),
      nb::cast<double>(properties["Range"][1]) };
  }
  task.Spacing = ValueOf<double>(properties, "Spacing");
  task.Extrapolate = ValueOf<bool>(properties, "Extrapolate");
  task.SmallestArea = ValueOf<double>(properties, "SmallestArea");
  if (task.PlanesOfLoops)
  {
    const auto given = nb::borrow<nb::dict>(planes);
    task.PixelArea = ValueOf<double>(given, "pixel_area");
    const nb::object tolerance = given["tolerance"];
    task.Tolerance =
      tolerance.is_none() ? std::nullopt : std::optional<double>(nb::cast<double>(tolerance));
  }
  return task;
}

std::vector<TracePlane> PlanesOf(const TracingTask& task, const std::vector<Point3>& seeds)
{
  if (task.PlanesOfLoops)
  {
    ContourSetOptions options;
    options.Parallel = false;
    Monitor silent;
    return PlanesOf(BuildContourSet(*task.PlanesOfLoops, options, silent));
  }
  return task.Planes ? *task.Planes
                     : ParallelPlanesThrough(seeds, task.Normal, task.Range, task.Spacing);
}

/// Implicit Constraints, Implicit Function and Implicit Contours in one.
Made<ContourSet> Trace(const TracingTask& task, Monitor& monitor)
{
  SubMonitor fitting(monitor, 0.0, 0.8);
  SubMonitor tracing(monitor, 0.8, 1.0);
  Made<ContourSet> made;
  made.Contours = BuildContourSet(task.Soup, task.Reading, fitting);
  const ContourFit fit = FitContours(made.Contours, task.Constraints, task.Function, fitting);
  made.Report = made.Contours.Report;
  for (const auto* lines : { &fit.Constraints.Report, &fit.Function.Report })
  {
    made.Report.insert(made.Report.end(), lines->begin(), lines->end());
  }
  const std::vector<Point3> seeds = SeedsOf(fit.Function);
  std::vector<TracePlane> planes = PlanesOf(task, seeds);
  if ((task.Planes || task.PlanesOfLoops) && !task.Extrapolate)
  {
    planes = OnlyPlanesWithin(planes, seeds, task.Tolerance, made.Report);
  }
  TracerOptions options = task.Tracer;
  options.SmallestArea = task.SmallestArea != 0
    ? std::max(0.0, task.SmallestArea)
    : SpeckArea(task.PixelArea, SmallestArea(made.Contours));
  made.Output = TraceContours(fit.Function, seeds, planes, options, tracing);
  return made;
}

nb::dict OnPlanes(
  const nb::dict& loops, nb::handle planes, const nb::dict& properties, nb::handle progress)
{
  const TracingTask task = TracingTaskOf(loops, planes, properties);
  const Made<ContourSet> made =
    RunWithoutLock(progress, [&](Monitor& monitor) { return Trace(task, monitor); });
  nb::dict result = FromContours(made.Output);
  AddReport(made.Report, made.Output.Report, made.Contours.Warning, result);
  return result;
}

/// A flag, a whole number or a number; None where the figure has no meaning.
nb::object FromFigure(const CertificateFigure& figure)
{
  if (!figure.Value)
  {
    return nb::none();
  }
  switch (figure.Kind)
  {
    case CertificateFigure::Flag:
      return nb::bool_(*figure.Value != 0);
    case CertificateFigure::Count:
      return nb::int_(static_cast<long long>(*figure.Value));
    case CertificateFigure::Real:
      break;
  }
  return nb::float_(*figure.Value);
}

nb::dict FromFigures(const std::vector<CertificateFigure>& figures)
{
  nb::dict result;
  for (const CertificateFigure& figure : figures)
  {
    result[figure.Name.c_str()] = FromFigure(figure);
  }
  return result;
}

nb::dict FromSections(const std::vector<SectionDifference>& sections)
{
  const auto orNaN = [](const std::optional<double>& value)
  { return value.value_or(std::numeric_limits<double>::quiet_NaN()); };
  using Section = SectionDifference;
  nb::dict result;
  result["SectionOffset"] = ArrayOf(sections, [](const Section& s) { return s.Offset; });
  result["SectionContourArea"] = ArrayOf(sections, [](const Section& s) { return s.ContourArea; });
  result["SectionSurfaceArea"] =
    ArrayOf(sections, [&](const Section& s) { return orNaN(s.SurfaceArea); });
  result["SectionDifference"] =
    ArrayOf(sections, [&](const Section& s) { return orNaN(s.SymmetricDifference); });
  result["SectionPercent"] = ArrayOf(sections, [&](const Section& s) { return orNaN(s.Percent); });
  return result;
}

nb::dict FromDoubts(const std::optional<VolumeInterval>& volume)
{
  const std::vector<VolumeDoubt> doubts = volume ? volume->Doubts : std::vector<VolumeDoubt>();
  nb::dict result;
  result["DoubtOffset"] = ArrayOf(doubts, [](const VolumeDoubt& d) { return d.Offset; });
  result["DoubtWidth"] = ArrayOf(doubts, [](const VolumeDoubt& d) { return d.Width; });
  return result;
}

nb::dict FromCertificate(SurfaceCertificate certificate)
{
  nb::dict result;
  nb::list components;
  for (const ComponentCertificate& component : certificate.Components)
  {
    components.append(FromFigures(ListFigures(component)));
  }
  result["sound"] = certificate.Total.IsSound();
  result["figures"] = FromFigures(ListFigures(certificate.Total));
  result["contour_figures"] = FromFigures(ListContourFigures(certificate));
  result["components"] = components;
  result["sections"] = FromSections(certificate.Sections);
  result["doubts"] = FromDoubts(certificate.Drawn);
  result["text"] = ToList(ToShortText(certificate));
  result["json"] = ToJson(certificate);
  result["defect"] = ToNumpy(std::move(certificate.DefectOfTriangle));
  result["component_id"] = ToNumpy(std::move(certificate.ComponentOfTriangle));
  return result;
}

nb::dict Certificate(const GivenPoints& points, const GivenTriangles& triangles,
  nb::handle contours, double rounding, const nb::dict& properties, nb::handle progress)
{
  const TriangleMesh mesh = MeshOf(points, triangles);
  const std::optional<LoopSoup> soup = contours.is_none()
    ? std::nullopt
    : std::optional<LoopSoup>(SoupOf(nb::borrow<nb::dict>(contours)));
  const std::optional<CarriedMapping> carried =
    soup ? CarriedMappingOf(nb::borrow<nb::dict>(contours)) : std::nullopt;
  CertificateOptions options;
  options.Weld = ValueOf<bool>(properties, "Weld");
  options.Threads = ValueOf<int>(properties, "Threads");
  options.CoordinateRounding = rounding;
  ContourSet set;
  nb::dict result = FromCertificate(RunWithoutLock(progress,
    [&](Monitor& monitor)
    {
      ContourSetOptions reading;
      reading.Parallel = false;
      Monitor quiet; // reading the contours takes no time worth a progress bar
      set = soup ? BuildContourSet(*soup, reading, quiet) : ContourSet();
      SurfaceCertificate made = Certify(mesh, soup ? &set : nullptr, options, monitor);
      made.Drawn = soup ? EstimateVolume(*soup, set, carried, quiet) : std::nullopt;
      return made;
    }));
  AddReport(set.Report, {}, set.Warning, result);
  return result;
}
}

void BindSurfaces(nb::module_& module)
{
  module.def("polyhedral_surface", &Polyhedral, nb::arg("loops"), nb::arg("properties"),
    nb::arg("progress").none());
  module.def(
    "fair_surface", &Fair, nb::arg("loops"), nb::arg("properties"), nb::arg("progress").none());
  module.def("implicit_surface", &Implicit, nb::arg("loops"), nb::arg("properties"),
    nb::arg("progress").none());
  module.def("contours_on_planes", &OnPlanes, nb::arg("loops"), nb::arg("planes").none(),
    nb::arg("properties"), nb::arg("progress").none());
  module.def("certificate", &Certificate, nb::arg("points"), nb::arg("triangles"),
    nb::arg("contours").none(), nb::arg("rounding"), nb::arg("properties"),
    nb::arg("progress").none());
}
}
