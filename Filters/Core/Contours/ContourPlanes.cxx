// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/ContourPlanes.h"

#include "Base/Angles.h"
#include "Contours/LevelGrouping.h"
#include "Contours/RingDirections.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace recon
{
namespace
{
// Points within this part of the diagonal of a plane lie in it, whatever else is known.
constexpr double FlatShare = 1e-5;
// Single precision numbers, as some file formats store coordinates, differ by this much.
constexpr double StorageRounding = 2.4e-7;

class Grouper
{
public:
  Grouper(const LoopSoup& soup, const std::vector<Ring>& rings, const PlaneOptions& options,
    ContourNotes& notes, Monitor& monitor)
    : Soup(soup),
      Rings(rings),
      Options(options),
      Gap(std::max(options.Tolerance, FlatShare * options.Size)),
      Directions(soup, rings, Gap, monitor),
      Notes(notes),
      Progress(monitor)
  {
  }

  PlaneGrouping Group()
  {
    this->LevelsAreKnown = this->LieOnKnownLevels();
    if (this->LevelsAreKnown)
    {
      const std::optional<PlaneGrouping> known = this->KnownPlanes();
      if (known)
      {
        return *known;
      }
    }
    this->AllowForRoughness();
    Vector3 normal = this->Directions.CommonNormal();
    std::vector<int> flat = this->Directions.FlatRings(normal);
    if (flat.size() < this->Rings.size())
    {
      const NearlyParallel nearly = this->Directions.FindNearlyParallel(
        normal, this->Options.Tolerance, this->Soup.Millimetres);
      if (nearly.Rings.size() > flat.size())
      {
        this->NoteTilt(nearly);
        normal = nearly.Normal;
        flat = nearly.Rings;
      }
    }
    if (flat.size() < this->Rings.size() && !this->Options.OnlyParallel)
    {
      return this->AnyPlanes();
    }
    PlaneGrouping grouping = this->Levels(normal, flat);
    this->NoteOtherDirections(normal, flat, grouping);
    return grouping;
  }

private:
  const std::vector<int>& PointsOf(int ring) const { return this->Rings[ring].Points; }

  // --- levels that an earlier filter has found

  /// Does the soup say of every ring in which level it is, and is every ring still there?
  bool LieOnKnownLevels() const
  {
    return !this->Rings.empty() &&
      std::all_of(this->Rings.begin(), this->Rings.end(),
        [this](const Ring& ring)
        {
          return ring.Level >= 0 && ring.Level < static_cast<int>(this->Soup.Levels.size()) &&
            this->LiesOn(ring, this->Soup.Levels[ring.Level]);
        });
  }

  bool LiesOn(const Ring& ring, const LoopSoup::KnownLevel& level) const
  {
    return std::all_of(ring.Points.begin(), ring.Points.end(),
      [&](int p)
      {
        const Point3& x = this->Soup.Points[p];
        return std::abs(Dot(level.Normal, x) - level.Offset) <=
          level.Thickness + StorageRounding * Norm(x);
      });
  }

  /// The planes that the soup knows of; empty where they are of several directions and one is
  /// wanted.
  std::optional<PlaneGrouping> KnownPlanes() const
  {
    const Vector3& normal = this->Soup.Levels[this->Rings[0].Level].Normal;
    const bool parallel = std::all_of(this->Rings.begin(), this->Rings.end(),
      [&](const Ring& ring) { return this->Soup.Levels[ring.Level].Normal == normal; });
    if (parallel)
    {
      std::vector<int> all(this->Rings.size());
      std::iota(all.begin(), all.end(), 0);
      return this->Levels(normal, all);
    }
    if (this->Options.OnlyParallel)
    {
      return std::nullopt;
    }
    PlaneGrouping grouping;
    for (const std::vector<int>& rings : this->ByKnownLevel())
    {
      grouping.Planes.push_back(this->MakePlane(
        PlanarFrame::About(this->Soup.Levels[this->Rings[rings[0]].Level].Normal), rings));
    }
    SortByFirstRing(grouping.Planes);
    return grouping;
  }

  std::vector<std::vector<int>> ByKnownLevel() const
  {
    std::vector<std::vector<int>> groups(this->Soup.Levels.size());
    for (std::size_t i = 0; i < this->Rings.size(); ++i)
    {
      groups[this->Rings[i].Level].push_back(static_cast<int>(i));
    }
    groups.erase(std::remove_if(groups.begin(), groups.end(),
                   [](const std::vector<int>& rings) { return rings.empty(); }),
      groups.end());
    return groups;
  }

  void AllowForRoughness()
  {
    const double roughness = this->Directions.AllowForRoughness();
    if (roughness > 0)
    {
      this->Notes.AddGeneral("Points lie up to " + Text(roughness) +
        " off the plane of their own contour, so planes were found with a tolerance of " +
        Text(this->Directions.GetTolerance()) + " instead of " + Text(this->Gap) + ".");
    }
  }

  void NoteTilt(const NearlyParallel& nearly)
  {
    const double degrees = nearly.LargestAngle / RadiansPerDegree;
    this->Notes.AddGeneral(Counted(nearly.Tilted, "contour") + " of " +
      std::to_string(this->Rings.size()) + (nearly.Tilted == 1 ? " is" : " are") +
      " not quite parallel to the others or not quite flat (the largest angle is " + Text(degrees) +
      " degrees, the farthest point " + Text(nearly.FarthestOff) +
      " off its level): taken as parallel, as that is little beside the " + Text(nearly.Spacing) +
      " between levels.");
  }

  // --- levels

  PlaneOfRings MakePlane(const PlanarFrame& frame, const std::vector<int>& rings) const
  {
    PlaneOfRings plane;
    plane.Frame = frame;
    plane.Rings = rings;
    OffsetRange range;
    for (int ring : rings)
    {
      const OffsetRange own = RangeAlong(this->Soup, this->Rings[ring], frame.Normal);
      range.Add(own.Low);
      range.Add(own.High);
    }
    plane.Offset = range.Middle();
    plane.Thickness = std::max(range.High - plane.Offset, plane.Offset - range.Low);
    return plane;
  }

  /// Flat rings by level, levels by offset.
  PlaneGrouping Levels(const Vector3& normal, const std::vector<int>& flat) const
  {
    PlaneGrouping grouping;
    grouping.Parallel = true;
    const PlanarFrame frame = PlanarFrame::About(normal);
    std::map<int, std::vector<int>> groups;
    LevelGrouping levels;
    if (!this->LevelsAreKnown)
    {
      std::vector<LevelCandidate> candidates;
      for (int ring : flat)
      {
        candidates.push_back(this->Directions.CandidateOf(frame, ring));
      }
      levels = GroupLevels(candidates, this->Options.Tolerance, this->Soup.Millimetres);
    }
    for (std::size_t i = 0; i < flat.size(); ++i)
    {
      groups[this->LevelsAreKnown ? this->Rings[flat[i]].Level : levels.LevelOf[i]].push_back(
        flat[i]);
    }
    for (const auto& [level, rings] : groups)
    {
      grouping.Planes.push_back(this->MakePlane(frame, rings));
    }
    this->NoteMerged(levels, grouping.Planes);
    std::stable_sort(grouping.Planes.begin(), grouping.Planes.end(),
      [](const PlaneOfRings& a, const PlaneOfRings& b) { return a.Offset < b.Offset; });
    return grouping;
  }

  void NoteMerged(const LevelGrouping& levels, const std::vector<PlaneOfRings>& planes) const
  {
    if (levels.Merged.empty())
    {
      return;
    }
    std::string places;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, levels.Merged.size()); ++i)
    {
      places += (i == 0 ? "" : ", ") + Text(planes[levels.Merged[i]].Offset);
    }
    if (levels.Merged.size() > 3)
    {
      places += " and " + std::to_string(levels.Merged.size() - 3) + " more";
    }
    this->Notes.AddGeneral("On " + Counted(levels.Merged.size(), "level") + " of " +
      std::to_string(levels.Count) + " (at offset " + places + ") contours lie up to " +
      Text(levels.WidestMerge) + " apart along the normal: taken as one level each, as all " +
      "that is nearer than " + Text(levels.Tolerance) +
      (this->Options.Tolerance > 0 ? " (PlaneTolerance)."
                                   : " is (found from the spacing; PlaneTolerance sets it)."));
  }

  static void SortByFirstRing(std::vector<PlaneOfRings>& planes)
  {
    std::sort(planes.begin(), planes.end(),
      [](const PlaneOfRings& a, const PlaneOfRings& b) { return a.Rings[0] < b.Rings[0]; });
  }

  /// Every ring joins the plane it is nearest to, where that is within tolerance, or starts a new
  /// one.
  PlaneGrouping AnyPlanes()
  {
    PlaneGrouping grouping;
    for (std::size_t i = 0; i < this->Directions.GetByArea().size(); ++i)
    {
      if (i % 64 == 0)
      {
        this->Progress.Update(0.25, "finding planes");
      }
      const int ring = this->Directions.GetByArea()[i];
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
        this->NoteNotPlanar(ring, this->Directions.GetTolerance(), "");
      }
    }
    for (PlaneOfRings& plane : grouping.Planes)
    {
      std::sort(plane.Rings.begin(), plane.Rings.end());
      const PlaneOfRings tight = this->MakePlane(plane.Frame, plane.Rings);
      plane.Thickness = tight.Thickness + std::abs(tight.Offset - plane.Offset);
    }
    SortByFirstRing(grouping.Planes);
    return grouping;
  }

  PlaneOfRings* NearestPlane(std::vector<PlaneOfRings>& planes, int ring) const
  {
    PlaneOfRings* nearest = nullptr;
    double least = this->Directions.GetTolerance();
    for (PlaneOfRings& plane : planes)
    {
      double farthest = 0;
      for (int p : this->PointsOf(ring))
      {
        farthest =
          std::max(farthest, std::abs(plane.Frame.OffsetOf(this->Soup.Points[p]) - plane.Offset));
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
    const RingPlane& own = this->Directions.PlaneOf(ring);
    if (!own.HasNormal)
    {
      return std::nullopt;
    }
    Vector3 normal = CanonicalNormal(own.AreaVector);
    std::optional<OffsetRange> range = this->Directions.FlatAlong(NearestAxis(normal), ring);
    if (range)
    {
      normal = NearestAxis(normal);
    }
    else
    {
      range = this->Directions.FlatAlong(normal, ring);
    }
    if (!range)
    {
      return std::nullopt;
    }
    PlaneOfRings plane;
    plane.Frame = PlanarFrame::About(normal);
    plane.Offset = range->Middle();
    plane.Rings = { ring };
    return plane;
  }

  // --- what is left out

  void NoteOtherDirections(
    const Vector3& normal, const std::vector<int>& flat, PlaneGrouping& grouping)
  {
    std::vector<bool> kept(this->Rings.size(), false);
    for (int ring : flat)
    {
      kept[ring] = true;
    }
    std::size_t others = 0;
    for (std::size_t i = 0; i < this->Rings.size(); ++i)
    {
      if (!kept[i])
      {
        others += this->NoteOtherDirection(normal, static_cast<int>(i)) ? 1 : 0;
      }
    }
    if (2 * others > this->Rings.size())
    {
      grouping.Warning = std::to_string(others) + " of " + Counted(this->Rings.size(), "contour") +
        (others == 1 ? " lies in a plane that is" : " lie in other planes that are") +
        " not parallel to the rest: Implicit Surface takes contours of planes of any direction.";
    }
  }

  /// Was it for its direction that the ring was left out?
  bool NoteOtherDirection(const Vector3& normal, int ring)
  {
    const std::optional<PlaneOfRings> own = this->OwnPlane(ring);
    if (!own)
    {
      this->NoteNotPlanar(
        ring, this->Directions.GetTolerance(), ", or a fifth of the distance to the next level");
      return false;
    }
    if (this->Directions.AngleTo(normal, ring) <= RingDirections::MostTilt)
    {
      const double off = 0.5 * RangeAlong(this->Soup, this->Rings[ring], normal).Size();
      this->Note(ring,
        "is tilted by " + Text(this->Directions.AngleTo(normal, ring) / RadiansPerDegree) +
          " degrees, so that its points are up to " + Text(off) +
          " off a level, more than a fifth of the distance to the next one; left out (a larger "
          "PlaneTolerance keeps it, and Implicit Surface takes it as it is)");
      return true;
    }
    const Vector3& n = own->Frame.Normal;
    this->Note(ring,
      "lies in a plane of normal (" + Text(n[0]) + ", " + Text(n[1]) + ", " + Text(n[2]) +
        "), which is not parallel to the others; left out");
    return true;
  }

  void NoteNotPlanar(int ring, double allowed, const std::string& alternative)
  {
    const RingPlane& own = this->Directions.PlaneOf(ring);
    if (!own.HasNormal)
    {
      this->Note(ring, "encloses no area, its points lie on a line; left out");
      return;
    }
    this->Note(ring,
      "is not planar, its points lie up to " + Text(own.Roughness) + " off their plane where " +
        Text(allowed) + alternative + " is allowed; left out (a larger PlaneTolerance keeps it)");
  }

  void Note(int ring, const std::string& what)
  {
    const Ring& r = this->Rings[ring];
    this->Notes.Add(r.Source, r.Points.size(), r.Points[0], what);
  }

  const LoopSoup& Soup;
  const std::vector<Ring>& Rings;
  const PlaneOptions& Options;
  double Gap; ///< that a point may be off a plane whatever the rings are like
  RingDirections Directions;
  ContourNotes& Notes;
  Monitor& Progress;
  bool LevelsAreKnown = false;
};
}

PlaneGrouping GroupByPlane(const LoopSoup& soup, const std::vector<Ring>& rings,
  const PlaneOptions& options, ContourNotes& notes, Monitor& monitor)
{
  return Grouper(soup, rings, options, notes, monitor).Group();
}
}
