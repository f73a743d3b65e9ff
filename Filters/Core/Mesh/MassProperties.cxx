// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/MassProperties.h"

#include "Base/Angles.h"
#include "Base/BoundingBox.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace recon
{
namespace
{
/// Neumaier's sum: the error does not grow with the number of terms.
class CompensatedSum
{
public:
  void Add(double x)
  {
    const double sum = this->Sum + x;
    this->Lost +=
      std::fabs(this->Sum) >= std::fabs(x) ? (this->Sum - sum) + x : (x - sum) + this->Sum;
    this->Sum = sum;
  }
  double Value() const { return this->Sum + this->Lost; }

private:
  double Sum = 0;
  double Lost = 0;
};

/// As if the corners were seen from the middle of the solid.
double VolumeBelow(const Vector3& a, const Vector3& ab, const Vector3& bc)
{
  // a . (b x c), the edges taken relative to a: smaller numbers, smaller errors.
  return Dot(a, Cross(ab, bc)) / 6;
}

struct Sums
{
  Box3 Bounds;
  Point3 Middle{ 0, 0, 0 };
  CompensatedSum Volume;
  CompensatedSum Area;
  std::array<CompensatedSum, 3> Moment; ///< of the solid, about Middle
  double LargestCotangent = -1;         ///< of the smallest angle; -1: no triangle yet
};

void GrowBounds(const TriangleMesh& mesh, const std::array<int, 3>& triangle, Sums& sums)
{
  for (const int p : triangle)
  {
    sums.Bounds.Add(mesh.Points[p]);
  }
}

void AddTriangle(const TriangleMesh& mesh, const std::array<int, 3>& triangle, Sums& sums)
{
  const Vector3 a = mesh.Points[triangle[0]] - sums.Middle;
  const Vector3 b = mesh.Points[triangle[1]] - sums.Middle;
  const Vector3 c = mesh.Points[triangle[2]] - sums.Middle;
  const Vector3 ab = b - a;
  const Vector3 bc = c - b;
  const Vector3 ca = a - c;
  const double doubledArea = Norm(Cross(ab, bc));
  sums.Area.Add(doubledArea / 2);
  const double volume = VolumeBelow(a, ab, bc);
  sums.Volume.Add(volume);
  for (int k = 0; k < 3; ++k)
  {
    sums.Moment[k].Add(volume * (a[k] + b[k] + c[k]) / 4);
  }
  sums.LargestCotangent =
    std::max(sums.LargestCotangent, CotangentOfSmallestAngle(ab, bc, ca, doubledArea));
}

/// What ComputeSignedVolumes asks for, and no more.
void AddVolume(const TriangleMesh& mesh, const std::array<int, 3>& triangle, Sums& sums)
{
  const Vector3 a = mesh.Points[triangle[0]] - sums.Middle;
  const Vector3 b = mesh.Points[triangle[1]] - sums.Middle;
  const Vector3 c = mesh.Points[triangle[2]] - sums.Middle;
  sums.Volume.Add(VolumeBelow(a, b - a, c - b));
}

/// Sums of each component and last, of the triangles of none.
template <typename Adder>
std::vector<Sums> AddUp(const TriangleMesh& mesh, const std::vector<int>& componentOfTriangle,
  int count, const Adder& add)
{
  std::vector<Sums> sums(count + 1);
  const auto of = [&](std::size_t t) -> Sums&
  { return sums[componentOfTriangle[t] < 0 ? count : componentOfTriangle[t]]; };
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    GrowBounds(mesh, mesh.Triangles[t], of(t));
  }
  for (auto& s : sums)
  {
    s.Middle = s.Bounds.IsEmpty() ? Point3{ 0, 0, 0 } : s.Bounds.Middle();
  }
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    add(mesh, mesh.Triangles[t], of(t));
  }
  return sums;
}

MassFigures ToFigures(const Sums& sums, bool encloses)
{
  MassFigures figures;
  if (sums.Bounds.IsEmpty())
  {
    return figures;
  }
  figures.Area = sums.Area.Value();
  figures.Low = sums.Bounds.Low;
  figures.High = sums.Bounds.High;
  figures.SmallestAngle = std::atan2(1.0, sums.LargestCotangent) / RadiansPerDegree;
  if (!encloses)
  {
    return figures;
  }
  const double volume = sums.Volume.Value();
  figures.Volume = volume;
  if (volume != 0)
  {
    figures.Centroid = sums.Middle;
    for (int k = 0; k < 3; ++k)
    {
      (*figures.Centroid)[k] += sums.Moment[k].Value() / volume;
    }
  }
  return figures;
}

/// The whole from its parts; `rest` are the triangles of no component, which have no area.
MassFigures Combine(const std::vector<MassFigures>& parts, const Sums& rest)
{
  MassFigures whole;
  CompensatedSum area, volume;
  std::array<CompensatedSum, 3> moment;
  Box3 bounds = rest.Bounds;
  bool encloses = !parts.empty();
  double angle = rest.Bounds.IsEmpty() ? 180 : 0;
  for (const auto& part : parts)
  {
    area.Add(part.Area);
    angle = std::min(angle, part.SmallestAngle);
    encloses = encloses && part.Volume;
    bounds.Add(Box3(part.Low, part.High));
    for (int k = 0; k < 3; ++k)
    {
      if (part.Centroid)
      {
        // Relative to one of the centroids, so that nothing is lost far from the origin.
        moment[k].Add(*part.Volume * ((*part.Centroid)[k] - parts.front().Low[k]));
      }
    }
    volume.Add(part.Volume.value_or(0));
  }
  if (bounds.IsEmpty())
  {
    return whole;
  }
  whole.Area = area.Value();
  whole.Low = bounds.Low;
  whole.High = bounds.High;
  whole.SmallestAngle = angle;
  if (encloses)
  {
    whole.Volume = volume.Value();
  }
  if (encloses && *whole.Volume != 0)
  {
    whole.Centroid = parts.front().Low;
    for (int k = 0; k < 3; ++k)
    {
      (*whole.Centroid)[k] += moment[k].Value() / *whole.Volume;
    }
  }
  return whole;
}
}

double ComputeSmallestAngle(const TriangleMesh& mesh)
{
  double largest = -std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.Triangles)
  {
    const Vector3 ab = mesh.Points[t[1]] - mesh.Points[t[0]];
    const Vector3 bc = mesh.Points[t[2]] - mesh.Points[t[1]];
    const Vector3 ca = mesh.Points[t[0]] - mesh.Points[t[2]];
    largest = std::max(largest, CotangentOfSmallestAngle(ab, bc, ca, Norm(Cross(ab, bc))));
  }
  return std::atan2(1.0, largest) / RadiansPerDegree;
}

std::vector<double> ComputeSignedVolumes(
  const TriangleMesh& mesh, const std::vector<int>& componentOfTriangle, int count)
{
  std::vector<double> volumes;
  const auto sums = AddUp(mesh, componentOfTriangle, count, AddVolume);
  for (int c = 0; c < count; ++c)
  {
    volumes.push_back(sums[c].Volume.Value());
  }
  return volumes;
}

std::vector<MassFigures> ComputeMassProperties(const TriangleMesh& mesh,
  const std::vector<int>& componentOfTriangle, const std::vector<bool>& encloses)
{
  const int count = static_cast<int>(encloses.size());
  const auto sums = AddUp(mesh, componentOfTriangle, count, AddTriangle);
  std::vector<MassFigures> figures;
  for (int c = 0; c < count; ++c)
  {
    figures.push_back(ToFigures(sums[c], encloses[c]));
  }
  figures.push_back(Combine(figures, sums[count]));
  return figures;
}
}
