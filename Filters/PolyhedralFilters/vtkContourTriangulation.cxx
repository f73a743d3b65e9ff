// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkContourTriangulation.h"

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

#include <cmath>

vtkStandardNewMacro(vtkContourTriangulation);

namespace
{
using Levels = std::vector<recon::LevelTriangulation>;

vtkSmartPointer<vtkPoints> NewPoints()
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  return points;
}

/// Input vertices keep their coordinates to the last bit; others are put into the level's plane.
recon::Point3 PositionOf(
  const recon::ContourSet& contours, std::size_t level, const recon::LevelTriangulation& t, int p)
{
  if (t.Source[p] >= 0)
  {
    return contours.Points[t.Source[p]];
  }
  const recon::Level& plane = contours.Levels[level];
  return plane.Frame.ToSpace(t.Points[p], plane.Offset);
}

void FillTriangles(const recon::ContourSet& contours, const Levels& levels, vtkPolyData* output)
{
  auto points = NewPoints();
  vtkNew<vtkCellArray> cells;
  std::vector<int> cellLevel, inside, contourEdges, pointLevel, pointKind, askedBy;
  for (std::size_t l = 0; l < levels.size(); ++l)
  {
    const recon::LevelTriangulation& t = levels[l];
    const vtkIdType first = points->GetNumberOfPoints();
    for (int p = 0; p < static_cast<int>(t.Points.size()); ++p)
    {
      points->InsertNextPoint(PositionOf(contours, l, t, p).data());
      pointLevel.push_back(static_cast<int>(l));
      pointKind.push_back(t.Kind[p]);
      askedBy.push_back(t.AskedBy[p]);
    }
    for (std::size_t k = 0; k < t.Triangles.size(); ++k)
    {
      cells->InsertNextCell(
        { first + t.Triangles[k][0], first + t.Triangles[k][1], first + t.Triangles[k][2] });
      cellLevel.push_back(static_cast<int>(l));
      inside.push_back(t.Inside[k]);
      int edges = 0;
      for (const int contour : t.EdgeContour[k])
      {
        edges += contour >= 0 ? 1 : 0;
      }
      contourEdges.push_back(edges);
    }
  }
  output->SetPoints(points);
  output->SetPolys(cells);
  recon::AddArray(output->GetCellData(), "Level", cellLevel);
  recon::AddArray(output->GetCellData(), "Inside", inside);
  recon::AddArray(output->GetCellData(), "ContourEdges", contourEdges);
  recon::AddArray(output->GetPointData(), "Level", pointLevel);
  recon::AddArray(output->GetPointData(), "PointKind", pointKind);
  recon::AddArray(output->GetPointData(), "AskedBy", askedBy);
}

/// Adds the Voronoi vertices of a level; the ids of those that exist, -1 for the others.
std::vector<vtkIdType> InsertVoronoiVertices(
  const recon::Level& plane, const recon::LevelTriangulation& t, vtkPoints* points)
{
  std::vector<vtkIdType> ids(t.Triangles.size(), -1);
  for (std::size_t k = 0; k < ids.size(); ++k)
  {
    const recon::Point2 vertex = t.VoronoiVertex(static_cast<int>(k));
    if (std::isfinite(vertex[0]) && std::isfinite(vertex[1]))
    {
      ids[k] = points->InsertNextPoint(plane.Frame.ToSpace(vertex, plane.Offset).data());
    }
  }
  return ids;
}

void FillSkeletons(const recon::ContourSet& contours, const Levels& levels, vtkPolyData* output)
{
  auto points = NewPoints();
  vtkNew<vtkCellArray> lines;
  std::vector<int> level, internal;
  for (std::size_t l = 0; l < levels.size(); ++l)
  {
    const recon::LevelTriangulation& t = levels[l];
    const std::vector<vtkIdType> ids = InsertVoronoiVertices(contours.Levels[l], t, points);
    for (int k = 0; k < static_cast<int>(t.Triangles.size()); ++k)
    {
      for (int e = 0; e < 3; ++e)
      {
        const int n = t.Neighbours[k][e];
        // A Voronoi edge that crosses a contour belongs to neither skeleton.
        if (n < k || t.EdgeContour[k][e] >= 0 || ids[k] < 0 || ids[n] < 0)
        {
          continue;
        }
        lines->InsertNextCell({ ids[k], ids[n] });
        level.push_back(static_cast<int>(l));
        internal.push_back(t.Inside[k]);
      }
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  recon::AddArray(output->GetCellData(), "Level", level);
  recon::AddArray(output->GetCellData(), "Internal", internal);
}

/// One plane has no neighbour to ask for internal points, and no slab, but can be looked at.
Levels Triangulate(const recon::ContourSet& contours, const recon::PolyhedralOptions& options,
  recon::Monitor& monitor, std::vector<std::string>& report)
{
  Levels levels;
  if (contours.Levels.size() > 1)
  {
    recon::PolyhedralStages stages = recon::BuildPolyhedralStages(contours, options, monitor);
    report.insert(report.end(), stages.Report.begin(), stages.Report.end());
    for (auto& level : stages.Levels)
    {
      levels.push_back(std::move(level.Triangulation));
      for (recon::Point2& point : levels.back().Points)
      {
        point = stages.Alignment.Undo(point, level.Offset);
      }
    }
    return levels;
  }
  levels.push_back(recon::LevelTriangulator(contours, 0).Finish());
  return levels;
}
}

//------------------------------------------------------------------------------
vtkContourTriangulation::vtkContourTriangulation()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
int vtkContourTriangulation::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0], 0);
  vtkPolyData* triangles = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* skeletons = vtkPolyData::GetData(outputVector, 1);
  return recon::RunCore(this, input, recon::NeedsContours, { triangles, skeletons },
    [&]
    {
      vtkContourMonitor cleaning(this, 0.0, 0.2);
      const recon::ContourSet contours = this->ReadContoursOfSolid(input, true, cleaning);
      std::vector<std::string> report = contours.Report;
      recon::PolyhedralOptions options =
        this->GetOptions(input, contours, vtkTable::GetData(inputVector[1], 0), report);
      vtkContourMonitor triangulating(this, this->MeetContract(contours, 0.2, options), 1.0);
      const Levels levels = Triangulate(contours, options, triangulating, report);
      FillTriangles(contours, levels, triangles);
      FillSkeletons(contours, levels, skeletons);
      for (vtkPolyData* output : { triangles, skeletons })
      {
        recon::AddLevels(contours, output);
        recon::FinishOutput(input, report, output);
      }
    });
}

//------------------------------------------------------------------------------
void vtkContourTriangulation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
