// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/RingDirections.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace recon
{
namespace
{
// Coordinates rounded to a few decimals make oblique contours less flat than the tolerance: where
// the rings themselves show it, up to this many tolerances are allowed ...
constexpr double MostRoughness = 30;
// ... or this many steps of the rounding, if that is small beside the ring.
constexpr double StepsOfRounding = 2;
constexpr double MostRoundingShare = 0.01;
// Planes that are not quite parallel are levels where no point is off by more than this part of the
// distance to the next level (and no ring turned by more than MostTilt).
constexpr double MostOffShare = 0.2;
// A coordinate axis is taken for the common normal where it is about as good as the best one.
constexpr double AxisBonus = 1.5;
}

RingDirections::RingDirections(
  const LoopSoup& soup, const std::vector<Ring>& rings, double gap, Monitor& monitor)
  : Soup(soup),
    Rings(rings),
    Gap(gap),
    Tolerance(gap),
    Progress(monitor)
{
  this->Planes.reserve(rings.size());
  for (const Ring& ring : rings)
  {
    this->Planes.push_back(FindRingPlane(soup, ring, this->Gap));
  }
  this->ByArea.resize(rings.size());
  std::iota(this->ByArea.begin(), this->ByArea.end(), 0);
  std::stable_sort(this->ByArea.begin(), this->ByArea.end(),
    [this](int a, int b)
    {
      const RingPlane& p = this->Planes[a];
      const RingPlane& q = this->Planes[b];
      return p.Trusted != q.Trusted ? p.Trusted : Norm(p.AreaVector) > Norm(q.AreaVector);
    });
}

double RingDirections::AllowForRoughness()
{
  const double step = CoordinateStep(this->Soup, this->Rings);
  double roughness = 0;
  double most = MostRoughness * this->Gap;
  for (const RingPlane& plane : this->Planes)
  {
    const double rounding = std::min(StepsOfRounding * step, MostRoundingShare * plane.Length);
    const double allowed = std::max(MostRoughness * this->Gap, rounding);
    if (plane.Trusted && plane.Roughness <= allowed)
    {
      roughness = std::max(roughness, plane.Roughness);
      most = std::max(most, allowed);
    }
  }
  if (roughness <= this->Gap)
  {
    return 0;
  }
  // The common plane of several rings fits each of them a little worse than its own.
  this->Tolerance = std::min(2 * roughness, most);
  return roughness;
}

/// Empty where the ring is thicker than the tolerance allows; stops at the first point that shows
/// it.
std::optional<OffsetRange> RingDirections::FlatAlong(const Vector3& normal, int ring) const
{
  OffsetRange range;
  for (int p : this->Rings[ring].Points)
  {
    range.Add(Dot(normal, this->Soup.Points[p]));
    if (range.Size() > 2 * this->Tolerance)
    {
      return std::nullopt;
    }
  }
  return range;
}

std::vector<int> RingDirections::FlatRings(const Vector3& normal) const
{
  std::vector<int> flat;
  for (std::size_t i = 0; i < this->Rings.size(); ++i)
  {
    if (this->FlatAlong(normal, static_cast<int>(i)))
    {
      flat.push_back(static_cast<int>(i));
    }
  }
  return flat;
}

bool RingDirections::AllFlatAlong(const Vector3& normal, const std::vector<int>& rings) const
{
  return std::all_of(rings.begin(), rings.end(),
    [&](int ring) { return this->FlatAlong(normal, ring).has_value(); });
}

/// The direction of most rings, then of most area; a ring belongs to the largest one before it
/// that it fits.
template <typename Fits>
RingDirections::Direction RingDirections::BestDirection(const Fits& fits)
{
  const bool anyTrusted = !this->ByArea.empty() && this->Planes[this->ByArea[0]].Trusted;
  std::vector<bool> assigned(this->Rings.size(), false);
  Direction best;
  std::size_t step = 0;
  for (int seed : this->ByArea)
  {
    const RingPlane& plane = this->Planes[seed];
    if (assigned[seed] || !plane.HasNormal || (anyTrusted && !plane.Trusted))
    {
      continue;
    }
    if (step++ % 64 == 0)
    {
      this->Progress.Update(0.2, "finding planes");
    }
    Direction direction;
    direction.Normal = CanonicalNormal(plane.AreaVector);
    for (int ring : this->ByArea)
    {
      const bool open =
        ring == seed || (!assigned[ring] && (this->Planes[ring].Trusted || !anyTrusted));
      if (open && (ring == seed || fits(direction.Normal, ring)))
      {
        assigned[ring] = true;
        direction.Rings.push_back(ring);
        direction.Area += Norm(this->Planes[ring].AreaVector);
      }
    }
    if (direction.Rings.size() > best.Rings.size() ||
      (direction.Rings.size() == best.Rings.size() && direction.Area > best.Area))
    {
      best = std::move(direction);
    }
  }
  return best;
}

/// The direction that most rings are flat along.
Vector3 RingDirections::CommonNormal()
{
  const Direction best = this->BestDirection(
    [this](const Vector3& normal, int ring) { return this->FlatAlong(normal, ring).has_value(); });
  return best.Rings.empty() ? best.Normal : this->Refined(best);
}

/// An axis where that is as good; else the mean by area, where that is as good; else as it is.
Vector3 RingDirections::Refined(const Direction& direction) const
{
  const Vector3 axis = NearestAxis(direction.Normal);
  if (this->AllFlatAlong(axis, direction.Rings))
  {
    return axis;
  }
  const Vector3 mean = this->MeanNormal(direction);
  return this->AllFlatAlong(mean, direction.Rings) ? mean : direction.Normal;
}

Vector3 RingDirections::MeanNormal(const Direction& direction) const
{
  Vector3 sum{ 0, 0, 0 };
  for (int ring : direction.Rings)
  {
    const Vector3& a = this->Planes[ring].AreaVector;
    sum = sum + (Dot(a, direction.Normal) < 0 ? -1.0 : 1.0) * a;
  }
  return CanonicalNormal(sum);
}

double RingDirections::AngleTo(const Vector3& normal, int ring) const
{
  const Vector3& a = this->Planes[ring].AreaVector;
  return std::atan2(Norm(Cross(a, normal)), std::abs(Dot(a, normal)));
}

/// Rings that are within a part of the slice distance of levels along one normal.
NearlyParallel RingDirections::FindNearlyParallel(
  const Vector3& flatNormal, double levelTolerance, bool millimetres)
{
  const Direction direction = this->BestDirection(
    [this](const Vector3& normal, int ring) { return this->AngleTo(normal, ring) <= MostTilt; });
  NearlyParallel found;
  found.Normal = this->BestNormal(direction, flatNormal);
  std::vector<int> near;
  std::vector<LevelCandidate> candidates;
  for (std::size_t i = 0; i < this->Rings.size(); ++i)
  {
    const int ring = static_cast<int>(i);
    const bool turned = this->Planes[i].Trusted && this->AngleTo(found.Normal, ring) > MostTilt;
    if (!turned || this->FlatAlong(found.Normal, ring))
    {
      near.push_back(ring);
      candidates.push_back(this->CandidateOf(PlanarFrame::About(found.Normal), ring));
      candidates.back().Noise = 0; // it has still to be seen how much of it is allowed
    }
  }
  const LevelGrouping levels = GroupLevels(candidates, levelTolerance, millimetres);
  found.Spacing = levels.Spacing;
  for (std::size_t i = 0; i < near.size(); ++i)
  {
    this->AddIfNear(near[i], levels.Room[levels.LevelOf[i]], found);
  }
  return found;
}

/// The normal that rings are off by the least altogether, or an axis that is nearly as good.
Vector3 RingDirections::BestNormal(const Direction& direction, const Vector3& flatNormal) const
{
  const Vector3 mean = this->MeanNormal(direction);
  const Vector3 axis = NearestAxis(mean);
  const auto off = [&](const Vector3& normal)
  {
    double sum = 0;
    for (int ring : direction.Rings)
    {
      sum += RangeAlong(this->Soup, this->Rings[ring], normal).Size();
    }
    return sum;
  };
  const double offMean = off(mean);
  const double offFlat = off(flatNormal);
  if (off(axis) <= AxisBonus * std::min(offMean, offFlat))
  {
    return axis;
  }
  return offFlat <= offMean ? flatNormal : mean;
}

void RingDirections::AddIfNear(int ring, double room, NearlyParallel& found) const
{
  const double off = 0.5 * RangeAlong(this->Soup, this->Rings[ring], found.Normal).Size();
  const double allowed =
    std::isfinite(room) ? std::max(this->Tolerance, MostOffShare * room) : this->Tolerance;
  if (off > allowed)
  {
    return;
  }
  found.Rings.push_back(ring);
  found.FarthestOff = std::max(found.FarthestOff, off);
  if (off > this->Tolerance)
  {
    ++found.Tilted;
    found.LargestAngle = std::max(found.LargestAngle, this->AngleTo(found.Normal, ring));
  }
}

LevelCandidate RingDirections::CandidateOf(const PlanarFrame& frame, int ring) const
{
  LevelCandidate candidate;
  const OffsetRange range = RangeAlong(this->Soup, this->Rings[ring], frame.Normal);
  candidate.Offset = range.Middle();
  const RingPlane& own = this->Planes[ring];
  candidate.Noise = 0.5 * range.Size();
  if (own.HasNormal)
  {
    candidate.Noise = std::min(candidate.Noise, own.Roughness);
  }
  OffsetRange u;
  OffsetRange v;
  for (int p : this->Rings[ring].Points)
  {
    const Point2 planar = frame.ToPlane(this->Soup.Points[p]);
    u.Add(planar[0]);
    v.Add(planar[1]);
  }
  candidate.Low = { u.Low, v.Low };
  candidate.High = { u.High, v.High };
  return candidate;
}
}
