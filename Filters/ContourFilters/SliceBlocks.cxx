// SPDX-License-Identifier: GPL-3.0-or-later
#include "SliceBlocks.h"

#include "Base/Geometry.h"
#include "SurfaceBlocks.h"

#include "vtkAppendPolyData.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace recon
{
namespace
{
/// Parts of the size, and of the largest coordinate where that is in single precision, that points
/// may be off a common plane.
constexpr double OffPlane = 1e-6;
constexpr double OffByRounding = 2.0 * FLT_EPSILON;

std::vector<Point3> PointsOf(vtkPolyData* data)
{
  std::vector<Point3> points(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    data->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  return points;
}

double Length(const Vector3& v)
{
  return std::sqrt(Dot(v, v));
}

/// Of the points the one of which a function says most.
template <typename Measure>
Point3 FarthestOf(const std::vector<Point3>& points, const Measure& measure)
{
  return *std::max_element(points.begin(), points.end(),
    [&](const Point3& a, const Point3& b) { return measure(a) < measure(b); });
}

bool IsFlat(vtkPolyData* data)
{
  const std::vector<Point3> points = PointsOf(data);
  const Point3& origin = points.front();
  const Vector3 along =
    FarthestOf(points, [&](const Point3& p) { return Length(p - origin); }) - origin;
  const Vector3 across =
    FarthestOf(points, [&](const Point3& p) { return Length(Cross(along, p - origin)); }) - origin;
  const Vector3 normal = Cross(along, across);
  const double size = Length(normal);
  if (size == 0)
  {
    return true; // a line, a point
  }
  const double largest = std::abs(*std::max_element(data->GetBounds(), data->GetBounds() + 6,
    [](double a, double b) { return std::abs(a) < std::abs(b); }));
  const double allowed = OffPlane * Length(along) + OffByRounding * largest;
  return std::all_of(points.begin(), points.end(),
    [&](const Point3& p) { return std::abs(Dot(normal, p - origin)) <= allowed * size; });
}

bool IsRegion(vtkPolyData* data)
{
  return data->GetFieldData()->HasArray("ROIName") || data->GetFieldData()->HasArray("Material");
}
}

std::vector<vtkPolyData*> FindFlatBlocks(vtkDataObject* object)
{
  std::vector<vtkPolyData*> slices;
  if (!object || vtkPolyData::SafeDownCast(object))
  {
    return slices;
  }
  for (const NamedPolyData& block : ListPolyData(object))
  {
    if (block.Data->GetNumberOfCells() == 0)
    {
      continue;
    }
    if (IsRegion(block.Data) || block.Data->GetNumberOfPoints() == 0 || !IsFlat(block.Data))
    {
      return {};
    }
    slices.push_back(block.Data);
  }
  return slices;
}

std::vector<vtkPolyData*> FindSliceBlocks(vtkDataObject* object)
{
  const std::vector<vtkPolyData*> flat = FindFlatBlocks(object);
  return flat.size() > 1 ? flat : std::vector<vtkPolyData*>();
}

vtkSmartPointer<vtkPolyData> JoinBlocks(const std::vector<vtkPolyData*>& blocks)
{
  vtkNew<vtkAppendPolyData> append;
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (vtkPolyData* block : blocks)
  {
    vtkNew<vtkPolyData> copy; // so that the input's pipeline stays out of it
    copy->ShallowCopy(block);
    append->AddInputData(copy);
  }
  append->Update();
  return append->GetOutput();
}
}
