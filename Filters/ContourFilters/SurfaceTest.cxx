// SPDX-License-Identifier: GPL-3.0-or-later
#include "SurfaceTest.h"

#include "Base/Geometry.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace recon
{
namespace
{
/// A polygon is turned against another where the cosine between their normals is below this: far
/// more than rounding turns contours of one plane, less than neighbours in a finely meshed sphere.
constexpr double FlatCosine = 0.9999;

/// Of every point the first with its coordinates.
std::vector<vtkIdType> WeldExactly(vtkPolyData* data)
{
  std::vector<Point3> places(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    data->GetPoint(static_cast<vtkIdType>(p), places[p].data());
  }
  std::vector<vtkIdType> order(places.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](vtkIdType a, vtkIdType b)
    { return places[a] < places[b] || (places[a] == places[b] && a < b); });
  std::vector<vtkIdType> first(places.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool repeats = i > 0 && places[order[i]] == places[order[i - 1]];
    first[order[i]] = repeats ? first[order[i - 1]] : order[i];
  }
  return first;
}

Vector3 UnitNormalOf(vtkPolyData* data, vtkIdList* polygon)
{
  Vector3 sum{};
  Point3 origin{};
  data->GetPoint(polygon->GetId(0), origin.data());
  for (vtkIdType i = 1; i + 1 < polygon->GetNumberOfIds(); ++i)
  {
    Point3 a{};
    Point3 b{};
    data->GetPoint(polygon->GetId(i), a.data());
    data->GetPoint(polygon->GetId(i + 1), b.data());
    sum = sum + Cross(a - origin, b - origin);
  }
  const double length = std::sqrt(Dot(sum, sum));
  return length > 0 ? (1 / length) * sum : Vector3{};
}

/// Sets of polygons that hang together, each named by one of its own.
class Sheets
{
public:
  explicit Sheets(std::size_t count) : Parent(count) { std::iota(Parent.begin(), Parent.end(), 0); }

  std::size_t RootOf(std::size_t i)
  {
    while (this->Parent[i] != i)
    {
      i = this->Parent[i] = this->Parent[this->Parent[i]];
    }
    return i;
  }

  void Join(std::size_t a, std::size_t b) { this->Parent[this->RootOf(a)] = this->RootOf(b); }

private:
  std::vector<std::size_t> Parent;
};

struct Side
{
  std::array<vtkIdType, 2> Edge;
  std::size_t Polygon;
};

/// Of every polygon its sheet and its normal.
struct Polygons
{
  explicit Polygons(vtkPolyData* data) : Sheet(static_cast<std::size_t>(data->GetNumberOfPolys()))
  {
    const std::vector<vtkIdType> first = WeldExactly(data);
    std::vector<Side> sides;
    vtkNew<vtkIdList> polygon;
    for (vtkIdType i = 0; i < data->GetNumberOfPolys(); ++i)
    {
      data->GetPolys()->GetCellAtId(i, polygon);
      const vtkIdType corners = polygon->GetNumberOfIds();
      this->Normals.push_back(corners > 2 ? UnitNormalOf(data, polygon) : Vector3{});
      for (vtkIdType k = 0; k < corners; ++k)
      {
        const vtkIdType a = first[polygon->GetId(k)];
        const vtkIdType b = first[polygon->GetId((k + 1) % corners)];
        sides.push_back({ { std::min(a, b), std::max(a, b) }, static_cast<std::size_t>(i) });
      }
    }
    std::sort(
      sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.Edge < b.Edge; });
    for (std::size_t i = 1; i < sides.size(); ++i)
    {
      if (sides[i].Edge == sides[i - 1].Edge)
      {
        this->Sheet.Join(sides[i].Polygon, sides[i - 1].Polygon);
      }
    }
  }

  Sheets Sheet;
  std::vector<Vector3> Normals; ///< zero for polygons without area
};
}

bool IsSurface(vtkPolyData* data)
{
  const auto count = static_cast<std::size_t>(data->GetNumberOfPolys());
  if (count < 4) // the fewest that close
  {
    return false;
  }
  Polygons polygons(data);
  std::vector<Vector3> direction(count); // of a sheet: that of its first polygon with an area
  std::vector<char> bent(count, 0);
  std::vector<std::size_t> size(count, 0);
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t root = polygons.Sheet.RootOf(i);
    const Vector3& normal = polygons.Normals[i];
    ++size[root];
    if (Dot(normal, normal) == 0)
    {
      continue;
    }
    if (Dot(direction[root], direction[root]) == 0)
    {
      direction[root] = normal;
    }
    else if (std::abs(Dot(normal, direction[root])) < FlatCosine)
    {
      bent[root] = 1;
    }
  }
  std::size_t inBent = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    inBent += bent[i] ? size[i] : 0;
  }
  return 2 * inBent > count;
}
}
