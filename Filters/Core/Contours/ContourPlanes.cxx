// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/ContourPlanes.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace recon
{
namespace
{
// A ring whose width is less than this many tolerances does not tell its plane by itself.
constexpr double TrustedWidth = 10;
// Coordinates rounded to a few decimals make oblique contours less flat than the tolerance: where
// the rings themselves show it, up to this many tolerances are allowed.
constexpr double MostRoughness = 30;

std::size_t Index(int i)
{
  return static_cast<std::size_t>(i);
}

/// Smallest and largest offset of a ring's points along a direction.
struct Extent
{
  double Low = std::numeric_limits<double>::infinity();
  double High = -std::numeric_limits<double>::infinity();
  double Size() const { return this->High - this->Low; }
  double Middle() const { return this->Low + 0.5 * (this->High - this->Low); }
  void Add(double x)
  {
    this->Low = std::min(this->Low, x);
    this->High = std::max(this->High, x);
  }
};

/// What a ring tells about its own plane.
struct RingPlane
{
  Vector3 AreaVector{ 0, 0, 0 }; ///< along the normal, as long as the area that tells it
  bool HasNormal = false;        ///< false where the points lie on a line
  bool Trusted = false;          ///< wide enough, compared with the tolerance
};

/// Newell's vector area about the ring's first point.
Vector3 NewellArea(const LoopSoup& soup, const Ring& ring)
{
  const Point3& o = soup.Points[Index(ring.Points[0])];
  Vector3 sum{ 0, 0, 0 };
  for (std::size_t i = 1; i + 1 < ring.Points.size(); ++i)
  {
    const Vector3 a = soup.Points[Index(ring.Points[i])] - o;
    const Vector3 b = soup.Points[Index(ring.Points[i + 1])] - o;
    sum = sum + 0.5 * Cross(a, b);
  }
  return sum;
}

/// The widest triangle over the ring's longest chord: also there where Newell's sum cancels (a bow
/// tie).
Vector3 WidestTriangle(const LoopSoup& soup, const Ring& ring, double& length)
{
  const Point3& o = soup.Points[Index(ring.Points[0])];
  Vector3 chord{ 0, 0, 0 };
  for (int p : ring.Points)
  {
    const Vector3 d = soup.Points[Index(p)] - o;
    chord = Norm(d) > Norm(chord) ? d : chord;
  }
  Vector3 widest{ 0, 0, 0 };
  for (int p : ring.Points)
  {
    const Vector3 c = 0.5 * Cross(chord, soup.Points[Index(p)] - o);
    widest = Norm(c) > Norm(widest) ? c : widest;
  }
  length = Norm(chord);
  return widest;
}

RingPlane PlaneOf(const LoopSoup& soup, const Ring& ring, double tolerance)
{
  RingPlane plane;
  double length = 0;
  const Vector3 widest = WidestTriangle(soup, ring, length);
  plane.AreaVector = NewellArea(soup, ring);
  if (Norm(plane.AreaVector) < 0.1 * Norm(widest))
  {
    plane.AreaVector = widest;
  }
  plane.HasNormal = Norm(plane.AreaVector) > 0;
  plane.Trusted = Norm(plane.AreaVector) > TrustedWidth * tolerance * length;
  return plane;
}

/// The unit vector along v, turned so that its largest component is positive.
Vector3 Canonical(const Vector3& v)
{
  std::size_t largest = 0;
  for (std::size_t k = 1; k < 3; ++k)
  {
    largest = std::abs(v[k]) > std::abs(v[largest]) ? k : largest;
  }
  return (v[largest] < 0 ? -1 / Norm(v) : 1 / Norm(v)) * v;
}

Vector3 NearestAxis(const Vector3& unit)
{
  Vector3 axis{ 0, 0, 0 };
  std::size_t largest = 0;
  for (std::size_t k = 1; k < 3; ++k)
  {
    largest = std::abs(unit[k]) > std::abs(unit[largest]) ? k : largest;
  }
  axis[largest] = 1;
  return axis;
}

/// A direction and the rings that are flat along it.
struct Direction
{
  Vector3 Normal{ 0, 0, 1 };
  std::vector<int> Rings;
  double Area = 0;
};

class Grouper
{
public:
  Grouper(const LoopSoup& soup, const std::vector<Ring>& rings, double tolerance,
    ContourNotes& notes, Monitor& monitor)
    : Soup(soup),
      Rings(rings),
      Gap(tolerance),
      Tolerance(tolerance),
      Notes(notes),
      Progress(monitor)
  {
    this->Planes.reserve(rings.size());
    for (const Ring& ring : rings)
    {
      this->Planes.push_back(PlaneOf(soup, ring, tolerance));
    }
    this->ByArea.resize(rings.size());
    std::iota(this->ByArea.begin(), this->ByArea.end(), 0);
    std::stable_sort(this->ByArea.begin(), this->ByArea.end(),
      [this](int a, int b)
      {
        const RingPlane& p = this->Planes[Index(a)];
        const RingPlane& q = this->Planes[Index(b)];
        return p.Trusted != q.Trusted ? p.Trusted : Norm(p.AreaVector) > Norm(q.AreaVector);
      });
    this->AllowForRoughness();
  }

  PlaneGrouping Group(bool onlyParallel)
  {
    const Vector3 normal = this->CommonNormal();
    std::vector<int> others;
    std::vector<std::pair<Extent, int>> flat;
    for (std::size_t i = 0; i < this->Rings.size(); ++i)
    {
      const std::optional<Extent> extent = this->FlatAlong(normal, static_cast<int>(i));
      if (extent)
      {
        flat.emplace_back(*extent, static_cast<int>(i));
      }
      else
      {
        others.push_back(static_cast<int>(i));
      }
    }
    if (others.empty() || onlyParallel)
    {
      for (int ring : others)
      {
        this->NoteOtherDirection(ring);
      }
      return this->Levels(normal, flat);
    }
    return this->AnyPlanes();
  }

private:
  void AllowForRoughness()
  {
    double roughness = 0;
    for (std::size_t i = 0; i < this->Rings.size(); ++i)
    {
      if (this->Planes[i].Trusted)
      {
        const double own = this->Roughness(static_cast<int>(i));
        roughness = own <= MostRoughness * this->Gap ? std::max(roughness, own) : roughness;
      }
    }
    if (roughness > this->Gap)
    {
      // The common plane of several rings fits each of them a little worse than its own.
      this->Tolerance = std::min(2 * roughness, MostRoughness * this->Gap);
      this->Notes.AddGeneral("Points lie up to " + Text(roughness) +
        " off the plane of their own contour, so planes were found with a tolerance of " +
        Text(this->Tolerance) + " instead of " + Text(this->Gap) + ".");
    }
  }

  /// Farthest distance of the ring's points from their own plane, which has to have a normal.
  double Roughness(int ring) const
  {
    const Vector3 normal = Canonical(this->Planes[Index(ring)].AreaVector);
    Extent extent;
    for (int p : this->Rings[Index(ring)].Points)
    {
      extent.Add(Dot(normal, this->Soup.Points[Index(p)]));
    }
    return 0.5 * extent.Size();
  }

  /// Empty where the ring is thicker than the tolerance allows; stops at the first point that shows
  /// it.
  std::optional<Extent> FlatAlong(const Vector3& normal, int ring) const
  {
    Extent extent;
    for (int p : this->Rings[Index(ring)].Points)
    {
      extent.Add(Dot(normal, this->Soup.Points[Index(p)]));
      if (extent.Size() > 2 * this->Tolerance)
      {
        return std::nullopt;
      }
    }
    return extent;
  }

  bool AllFlatAlong(const Vector3& normal, const std::vector<int>& rings) const
  {
    return std::all_of(rings.begin(), rings.end(),
      [&](int ring) { return this->FlatAlong(normal, ring).has_value(); });
  }

  /// The direction that most rings are flat along.
  Vector3 CommonNormal()
  {
    const bool anyTrusted = !this->ByArea.empty() && this->Planes[Index(this->ByArea[0])].Trusted;
    std::vector<bool> assigned(this->Rings.size(), false);
    Direction best;
    std::size_t step = 0;
    for (int seed : this->ByArea)
    {
      const RingPlane& plane = this->Planes[Index(seed)];
      if (assigned[Index(seed)] || !plane.HasNormal || (anyTrusted && !plane.Trusted))
      {
        continue;
      }
      if (step++ % 64 == 0)
      {
        this->Progress.Update(0.2, "finding planes");
      }
      Direction direction;
      direction.Normal = Canonical(plane.AreaVector);
      assigned[Index(seed)] = true;
      this->Collect(seed, anyTrusted, assigned, direction);
      if (direction.Rings.size() > best.Rings.size() ||
        (direction.Rings.size() == best.Rings.size() && direction.Area > best.Area))
      {
        best = std::move(direction);
      }
    }
    return best.Rings.empty() ? best.Normal : this->Refined(best);
  }

  void Collect(int seed, bool onlyTrusted, std::vector<bool>& assigned, Direction& direction) const
  {
    for (int ring : this->ByArea)
    {
      const RingPlane& plane = this->Planes[Index(ring)];
      const bool open = ring == seed || (!assigned[Index(ring)] && (plane.Trusted || !onlyTrusted));
      if (open && (ring == seed || this->FlatAlong(direction.Normal, ring)))
      {
        assigned[Index(ring)] = true;
        direction.Rings.push_back(ring);
        direction.Area += Norm(plane.AreaVector);
      }
    }
  }

  /// An axis where that is as good; else the mean by area, where that is as good; else as it is.
  Vector3 Refined(const Direction& direction) const
  {
    const Vector3 axis = NearestAxis(direction.Normal);
    if (this->AllFlatAlong(axis, direction.Rings))
    {
      return axis;
    }
    Vector3 sum{ 0, 0, 0 };
    for (int ring : direction.Rings)
    {
      const Vector3& a = this->Planes[Index(ring)].AreaVector;
      sum = sum + (Dot(a, direction.Normal) < 0 ? -1.0 : 1.0) * a;
    }
    const Vector3 mean = Canonical(sum);
    return this->AllFlatAlong(mean, direction.Rings) ? mean : direction.Normal;
  }

  /// Rings sorted by offset, a new level wherever the offsets of their points leave a gap.
  PlaneGrouping Levels(const Vector3& normal, std::vector<std::pair<Extent, int>>& flat) const
  {
    std::sort(flat.begin(), flat.end(),
      [](const auto& a, const auto& b)
      { return std::tie(a.first.Low, a.second) < std::tie(b.first.Low, b.second); });
    PlaneGrouping grouping;
    grouping.Parallel = true;
    const PlanarFrame frame = MakeFrame(normal);
    for (std::size_t i = 0; i < flat.size();)
    {
      PlaneOfRings plane;
      plane.Frame = frame;
      Extent extent;
      for (;
           i < flat.size() && (plane.Rings.empty() || flat[i].first.Low - extent.High <= this->Gap);
           ++i)
      {
        plane.Rings.push_back(flat[i].second);
        extent.Add(flat[i].first.Low);
        extent.Add(flat[i].first.High);
      }
      plane.Offset = extent.Middle();
      std::sort(plane.Rings.begin(), plane.Rings.end());
      grouping.Planes.push_back(std::move(plane));
    }
    return grouping;
  }

  /// Every ring joins the plane it is nearest to, where that is within tolerance, or starts a new
  /// one.
  PlaneGrouping AnyPlanes()
  {
    PlaneGrouping grouping;
    for (std::size_t i = 0; i < this->ByArea.size(); ++i)
    {
      if (i % 64 == 0)
      {
        this->Progress.Update(0.25, "finding planes");
      }
      const int ring = this->ByArea[i];
      PlaneOfRings* nearest = this->NearestPlane(grouping.Planes, ring);
      if (nearest)
      {
        nearest->Rings.push_back(ring);
        continue;
      }
      std::optional<PlaneOfRings> own = this->OwnPlane(ring);
      if (own)
      {
        grouping.Planes.push_back(std::move(*own));
      }
      else
      {
        this->NoteNotPlanar(ring);
      }
    }
    for (PlaneOfRings& plane : grouping.Planes)
    {
      std::sort(plane.Rings.begin(), plane.Rings.end());
    }
    std::sort(grouping.Planes.begin(), grouping.Planes.end(),
      [](const PlaneOfRings& a, const PlaneOfRings& b) { return a.Rings[0] < b.Rings[0]; });
    return grouping;
  }

  PlaneOfRings* NearestPlane(std::vector<PlaneOfRings>& planes, int ring) const
  {
    PlaneOfRings* nearest = nullptr;
    double least = this->Tolerance;
    for (PlaneOfRings& plane : planes)
    {
      double farthest = 0;
      for (int p : this->Rings[Index(ring)].Points)
      {
        farthest = std::max(
          farthest, std::abs(plane.Frame.OffsetOf(this->Soup.Points[Index(p)]) - plane.Offset));
        if (farthest > least)
        {
          break;
        }
      }
      if (farthest < least || (farthest <= least && !nearest))
      {
        least = farthest;
        nearest = &plane;
      }
    }
    return nearest;
  }

  std::optional<PlaneOfRings> OwnPlane(int ring) const
  {
    const RingPlane& own = this->Planes[Index(ring)];
    if (!own.HasNormal)
    {
      return std::nullopt;
    }
    Vector3 normal = Canonical(own.AreaVector);
    std::optional<Extent> extent = this->FlatAlong(NearestAxis(normal), ring);
    if (extent)
    {
      normal = NearestAxis(normal);
    }
    else
    {
      extent = this->FlatAlong(normal, ring);
    }
    if (!extent)
    {
      return std::nullopt;
    }
    PlaneOfRings plane;
    plane.Frame = MakeFrame(normal);
    plane.Offset = extent->Middle();
    plane.Rings = { ring };
    return plane;
  }

  void NoteOtherDirection(int ring)
  {
    const std::optional<PlaneOfRings> own = this->OwnPlane(ring);
    if (!own)
    {
      this->NoteNotPlanar(ring);
      return;
    }
    const Vector3& n = own->Frame.Normal;
    this->Note(ring,
      "lies in a plane of normal (" + Text(n[0]) + ", " + Text(n[1]) + ", " + Text(n[2]) +
        "), which is not parallel to the others; left out");
  }

  void NoteNotPlanar(int ring)
  {
    const RingPlane& own = this->Planes[Index(ring)];
    if (!own.HasNormal)
    {
      this->Note(ring, "encloses no area, its points lie on a line; left out");
      return;
    }
    this->Note(ring,
      "is not planar, its points lie up to " + Text(this->Roughness(ring)) +
        " off their plane where " + Text(this->Tolerance) + " is allowed; left out");
  }

  void Note(int ring, const std::string& what)
  {
    const Ring& r = this->Rings[Index(ring)];
    this->Notes.Add(r.Source, r.Points.size(), r.Points[0], what);
  }

  const LoopSoup& Soup;
  const std::vector<Ring>& Rings;
  double Gap;       ///< as the caller gave it
  double Tolerance; ///< the same, or more where the rings are rough
  ContourNotes& Notes;
  Monitor& Progress;
  std::vector<RingPlane> Planes;
  std::vector<int> ByArea;
};
}

PlanarFrame MakeFrame(const Vector3& unitNormal)
{
  PlanarFrame frame;
  frame.Normal = unitNormal;
  if (unitNormal[0] == 1)
  {
    frame.U = { 0, 1, 0 };
    frame.V = { 0, 0, 1 };
    return frame;
  }
  if (unitNormal[1] == 1)
  {
    frame.U = { 0, 0, 1 };
    frame.V = { 1, 0, 0 };
    return frame;
  }
  if (unitNormal[2] == 1)
  {
    return frame;
  }
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k)
  {
    least = std::abs(unitNormal[k]) < std::abs(unitNormal[least]) ? k : least;
  }
  Vector3 axis{ 0, 0, 0 };
  axis[least] = 1;
  const Vector3 u = Cross(axis, unitNormal);
  frame.U = (1 / Norm(u)) * u;
  frame.V = Cross(unitNormal, frame.U);
  return frame;
}

PlaneGrouping GroupByPlane(const LoopSoup& soup, const std::vector<Ring>& rings, bool onlyParallel,
  double tolerance, ContourNotes& notes, Monitor& monitor)
{
  return Grouper(soup, rings, tolerance, notes, monitor).Group(onlyParallel);
}
}
