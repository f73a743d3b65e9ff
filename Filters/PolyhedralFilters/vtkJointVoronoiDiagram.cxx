// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkJointVoronoiDiagram.h"

#include "ContourConversion.h"
#include "FieldArrays.h"
#include "Polyhedral/PolyhedralStages.h"
#include "RunCore.h"
#include "vtkContourMonitor.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

vtkStandardNewMacro(vtkJointVoronoiDiagram);

namespace
{
using Stages = recon::PolyhedralStages;
using Slabs = std::vector<recon::SlabState>;
using Tetrahedron = recon::SlabTetrahedra::Tetrahedron;

/// NodeType, Kept and Reason: a value a tetrahedron, for the cells of port 0 and the points of
/// port 1.
void AddNodeArrays(const Slabs& slabs, vtkFieldData* data)
{
  std::vector<int> nodeType, kept, reason;
  for (const recon::SlabState& slab : slabs)
  {
    for (const Tetrahedron& t : slab.Diagram.Tetrahedra)
    {
      nodeType.push_back(t.Node);
      kept.push_back(t.Reason == recon::SlabTetrahedra::Kept ? 1 : 0);
      reason.push_back(t.Reason);
    }
  }
  recon::AddArray(data, "NodeType", nodeType);
  recon::AddArray(data, "Kept", kept);
  recon::AddArray(data, "Reason", reason);
}

/// Number of the first point of every level, in the order of the levels.
std::vector<vtkIdType> InsertLevelPoints(
  const recon::ContourSet& contours, const Stages& stages, vtkUnstructuredGrid* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::vector<vtkIdType> first;
  std::vector<int> pointLevel, pointKind;
  for (std::size_t l = 0; l < stages.Levels.size(); ++l)
  {
    const recon::LevelTriangulation& t = stages.Levels[l].Triangulation;
    const recon::Level& plane = contours.Levels[l];
    first.push_back(points->GetNumberOfPoints());
    for (std::size_t p = 0; p < t.Points.size(); ++p)
    {
      const recon::Point3 position = t.Source[p] >= 0
        ? contours.Points[t.Source[p]]
        : plane.Frame.ToSpace(stages.Alignment.Undo(t.Points[p], plane.Offset), plane.Offset);
      points->InsertNextPoint(position.data());
      pointLevel.push_back(static_cast<int>(l));
      pointKind.push_back(t.Kind[p]);
    }
  }
  output->SetPoints(points);
  recon::AddArray(output->GetPointData(), "Level", pointLevel);
  recon::AddArray(output->GetPointData(), "PointKind", pointKind);
  return first;
}

void FillTetrahedra(
  const recon::ContourSet& contours, const Stages& stages, vtkUnstructuredGrid* output)
{
  const Slabs& slabs = stages.Slabs;
  const std::vector<vtkIdType> first = InsertLevelPoints(contours, stages, output);
  vtkNew<vtkCellArray> cells;
  std::vector<int> number;
  for (std::size_t s = 0; s < slabs.size(); ++s)
  {
    for (const Tetrahedron& t : slabs[s].Diagram.Tetrahedra)
    {
      vtkIdType ids[4];
      for (int k = 0; k < 4; ++k)
      {
        ids[k] = first[s + (recon::SlabTetrahedra::OnLevel2(t, k) ? 1 : 0)] + t.Corners[k];
      }
      cells->InsertNextCell(4, ids);
      number.push_back(static_cast<int>(s));
    }
  }
  output->SetCells(VTK_TETRA, cells);
  recon::AddArray(output->GetCellData(), "Slab", number);
  AddNodeArrays(slabs, output->GetCellData());
  output->GetCellData()->SetActiveScalars("Kept"); // which a view colours by
}

/// Planar corners of a tetrahedron.
std::array<recon::Point2, 4> CornersOf(const Tetrahedron& t, const recon::LevelTriangulation& lower,
  const recon::LevelTriangulation& upper)
{
  std::array<recon::Point2, 4> corners;
  for (int k = 0; k < 4; ++k)
  {
    const bool isUpper = recon::SlabTetrahedra::OnLevel2(t, k);
    corners[k] = (isUpper ? upper : lower).Points[t.Corners[k]];
  }
  return corners;
}

/// Where the perpendicular bisectors of ab and uv meet; not finite where they are parallel.
recon::Point2 CrossingOfBisectors(const std::array<recon::Point2, 4>& abuv)
{
  const auto& [a, b, u, v] = abuv;
  const double abx = b[0] - a[0], aby = b[1] - a[1];
  const double uvx = v[0] - u[0], uvy = v[1] - u[1];
  // Relative to a, so that little is lost far from the origin.
  const double mx = 0.5 * (u[0] + v[0]) - a[0], my = 0.5 * (u[1] + v[1]) - a[1];
  const double p = 0.5 * (abx * abx + aby * aby);
  const double q = uvx * mx + uvy * my;
  const double determinant = abx * uvy - aby * uvx;
  return { a[0] + (p * uvy - q * aby) / determinant, a[1] + (q * abx - p * uvx) / determinant };
}

recon::Point2 NodePosition(const Tetrahedron& t, const recon::LevelTriangulation& lower,
  const recon::LevelTriangulation& upper)
{
  const std::array<recon::Point2, 4> corners = CornersOf(t, lower, upper);
  recon::Point2 node;
  if (t.Node == recon::SlabTetrahedra::T12)
  {
    node = CrossingOfBisectors(corners);
  }
  else
  {
    node = (t.Node == recon::SlabTetrahedra::T1 ? lower : upper).VoronoiVertex(t.Origin[0]);
  }
  if (std::isfinite(node[0]) && std::isfinite(node[1]))
  {
    return node;
  }
  node = { 0, 0 };
  for (const recon::Point2& corner : corners)
  {
    node = { node[0] + 0.25 * corner[0], node[1] + 0.25 * corner[1] };
  }
  return node;
}

void FillGraph(const recon::ContourSet& contours, const Stages& stages, vtkPolyData* output)
{
  const Slabs& slabs = stages.Slabs;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  std::vector<int> number;
  for (std::size_t s = 0; s < slabs.size(); ++s)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    const double height = 0.5 * (contours.Levels[s].Offset + contours.Levels[s + 1].Offset);
    for (std::size_t i = 0; i < slabs[s].Diagram.Tetrahedra.size(); ++i)
    {
      const Tetrahedron& t = slabs[s].Diagram.Tetrahedra[i];
      const recon::Point2 node =
        NodePosition(t, stages.Levels[s].Triangulation, stages.Levels[s + 1].Triangulation);
      points->InsertNextPoint(
        contours.Levels[s].Frame.ToSpace(stages.Alignment.Undo(node, height), height).data());
      for (const int n : t.Neighbours)
      {
        if (n > static_cast<int>(i))
        {
          lines->InsertNextCell({ first + static_cast<vtkIdType>(i), first + n });
          number.push_back(static_cast<int>(s));
        }
      }
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  recon::AddArray(output->GetCellData(), "Slab", number);
  AddNodeArrays(slabs, output->GetPointData());
}
}

//------------------------------------------------------------------------------
vtkJointVoronoiDiagram::vtkJointVoronoiDiagram()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkUnstructuredGrid* vtkJointVoronoiDiagram::GetOutput()
{
  return vtkUnstructuredGrid::SafeDownCast(this->GetOutputDataObject(0));
}

//------------------------------------------------------------------------------
int vtkJointVoronoiDiagram::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkJointVoronoiDiagram::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0], 0);
  vtkUnstructuredGrid* tetrahedra = vtkUnstructuredGrid::GetData(outputVector, 0);
  vtkPolyData* graph = vtkPolyData::GetData(outputVector, 1);
  return recon::RunCore(this, input, recon::NeedsContours, { tetrahedra, graph },
    [&]
    {
      vtkContourMonitor cleaning(this, 0.0, 0.1);
      const recon::ContourSet contours = this->ReadContoursOfSolid(input, true, cleaning);
      std::vector<std::string> report = contours.Report;
      recon::PolyhedralOptions options =
        this->GetOptions(input, contours, vtkTable::GetData(inputVector[1], 0), report);
      vtkContourMonitor building(this, this->MeetContract(contours, 0.1, options), 1.0);
      const recon::PolyhedralStages stages =
        recon::BuildPolyhedralStages(contours, options, building);
      FillTetrahedra(contours, stages, tetrahedra);
      FillGraph(contours, stages, graph);
      report.insert(report.end(), stages.Report.begin(), stages.Report.end());
      for (vtkDataObject* output : std::initializer_list<vtkDataObject*>{ tetrahedra, graph })
      {
        recon::AddLevels(contours, output);
        recon::FinishOutput(input, report, output);
      }
    });
}

//------------------------------------------------------------------------------
void vtkJointVoronoiDiagram::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
