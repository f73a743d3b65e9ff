// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/ReferenceSlices.h"

#include "Base/Median.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace recon
{
namespace
{
/// What planning systems round coordinates to leaves a contour within this of its plane, mm.
constexpr double OnPlane = 0.1;
/// Sine of the angle below which a normal is that of another slice, or an axis.
constexpr double SameDirection = 1e-4;

/// Sorted offsets of the slices of the most frequent direction.
std::vector<double> OffsetsOfMost(const std::vector<ReferenceSlice>& slices)
{
  std::vector<double> most;
  std::vector<bool> done(slices.size(), false);
  for (std::size_t i = 0; i < slices.size(); ++i)
  {
    if (done[i])
    {
      continue;
    }
    std::vector<double> offsets;
    for (std::size_t j = i; j < slices.size(); ++j)
    {
      if (!done[j] && Norm(Cross(slices[i].Normal, slices[j].Normal)) < SameDirection)
      {
        done[j] = true;
        offsets.push_back(slices[j].Offset);
      }
    }
    if (offsets.size() > most.size())
    {
      most = std::move(offsets);
    }
  }
  std::sort(most.begin(), most.end());
  return most;
}

/// Those that differ: several series may have images in one plane.
std::vector<double> PlanesAmong(const std::vector<double>& offsets)
{
  std::vector<double> planes;
  for (const double offset : offsets)
  {
    if (planes.empty() || offset - planes.back() > OnPlane)
    {
      planes.push_back(offset);
    }
  }
  return planes;
}

/// The median distance of neighbours; 0 where there are no two planes.
double SpacingOf(const std::vector<double>& planes)
{
  std::vector<double> gaps;
  for (std::size_t i = 1; i < planes.size(); ++i)
  {
    gaps.push_back(planes[i] - planes[i - 1]);
  }
  return Median(std::move(gaps));
}

double DistanceTo(const ReferenceSlice& slice, const Point3& p)
{
  return std::abs(Dot(slice.Normal, p) - slice.Offset);
}
}

Vector3 SliceNormal(const Vector3& direction)
{
  const double length = Norm(direction);
  if (!(length > 0))
  {
    return { 0, 0, 0 };
  }
  Vector3 normal = (1 / length) * direction;
  const auto largest =
    static_cast<std::size_t>(std::max_element(normal.begin(), normal.end(),
                               [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      normal.begin());
  if (normal[largest] < 0)
  {
    normal = -1 * normal;
  }
  Vector3 axis{ 0, 0, 0 };
  axis[largest] = 1;
  return Norm(Cross(axis, normal)) < SameDirection ? axis : normal;
}

ReferenceSlices::ReferenceSlices(std::vector<ReferenceSlice> slices, std::size_t listed)
  : Slices(std::move(slices))
{
  const std::vector<double> planes = PlanesAmong(OffsetsOfMost(this->Slices));
  const double spacing = SpacingOf(planes);
  if (spacing == 0)
  {
    this->Tolerance = OnPlane;
    return;
  }
  const double intervals = std::round((planes.back() - planes.front()) / spacing);
  // With a slice between every two there would be twice as many intervals.
  const std::size_t unknown = listed - std::min(listed, this->Slices.size());
  const bool isTrueSpacing = static_cast<double>(planes.size() + unknown) < 2 * intervals + 1;
  this->Tolerance = isTrueSpacing ? spacing / 2 : std::min(OnPlane, spacing / 2);
}

const ReferenceSlice* ReferenceSlices::Find(const std::vector<Point3>& contour) const
{
  const ReferenceSlice* nearest = nullptr;
  double least = this->Tolerance;
  for (const ReferenceSlice& slice : this->Slices)
  {
    double farthest = 0;
    for (std::size_t i = 0; i < contour.size() && farthest <= least; ++i)
    {
      farthest = std::max(farthest, DistanceTo(slice, contour[i]));
    }
    if (farthest <= least && (!nearest || farthest < least))
    {
      least = farthest;
      nearest = &slice;
    }
  }
  return nearest;
}
}
