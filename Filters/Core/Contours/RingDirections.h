// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file RingDirections.h
 * @brief The normal that most rings have in common, and how flat they are along it.
 */
#ifndef recon_RingDirections_h
#define recon_RingDirections_h

#include "Base/Angles.h"
#include "Base/Monitor.h"
#include "Contours/LevelGrouping.h"
#include "Contours/RingPlane.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace recon
{
/// Rings along a common normal that are flat enough, and what that took.
struct NearlyParallel
{
  Vector3 Normal{ 0, 0, 1 };
  std::vector<int> Rings;
  std::size_t Tilted = 0; ///< of them are less flat than the tolerance
  double LargestAngle = 0;
  double FarthestOff = 0;
  double Spacing = 0;
};

/**
 * @class RingDirections
 * @brief Rings, the planes that they tell by themselves, and the tolerances that follow from both.
 */
class RingDirections
{
public:
  /// A ring is left aside that is turned by more than this, unless it is too narrow to tell.
  static constexpr double MostTilt = 3 * Pi / 180;

  /// @param gap distance from a plane that is allowed whatever the rings are like
  RingDirections(
    const LoopSoup& soup, const std::vector<Ring>& rings, double gap, Monitor& monitor);

  /// Raises the tolerance to what rounded coordinates explain.
  /// @returns the farthest distance of a point from its own plane, where that was needed, else 0
  double AllowForRoughness();

  /// Distance from a plane within which a point lies in it.
  double GetTolerance() const { return this->Tolerance; }
  const RingPlane& PlaneOf(int ring) const { return this->Planes[ring]; }
  /// Numbers of the rings, those that tell their plane best first.
  const std::vector<int>& GetByArea() const { return this->ByArea; }

  /// Empty where the ring is thicker than the tolerance allows; stops at the first point that shows
  /// it.
  std::optional<OffsetRange> FlatAlong(const Vector3& normal, int ring) const;
  std::vector<int> FlatRings(const Vector3& normal) const;
  /// The direction that most rings are flat along; an axis where that is as good, else the mean by
  /// area, where that is as good.
  Vector3 CommonNormal();
  /// Between the normal and that of the ring's own plane, in radians, at most a right angle.
  double AngleTo(const Vector3& normal, int ring) const;

  /**
   * Rings of one direction that are within a fifth of the distance to the next level.
   *
   * @param flatNormal what CommonNormal found: kept where it is as good as any
   * @param levelTolerance and millimetres as for GroupLevels
   */
  NearlyParallel FindNearlyParallel(
    const Vector3& flatNormal, double levelTolerance, bool millimetres);

  LevelCandidate CandidateOf(const PlanarFrame& frame, int ring) const;

private:
  /// A direction and the rings that are flat along it.
  struct Direction
  {
    Vector3 Normal{ 0, 0, 1 };
    std::vector<int> Rings;
    double Area = 0;
  };

  template <typename Fits>
  Direction BestDirection(const Fits& fits);
  bool AllFlatAlong(const Vector3& normal, const std::vector<int>& rings) const;
  Vector3 Refined(const Direction& direction) const;
  Vector3 MeanNormal(const Direction& direction) const;
  Vector3 BestNormal(const Direction& direction, const Vector3& flatNormal) const;
  void AddIfNear(int ring, double room, NearlyParallel& found) const;

  const LoopSoup& Soup;
  const std::vector<Ring>& Rings;
  double Gap;
  double Tolerance; ///< Gap, or more where the rings are rough
  Monitor& Progress;
  std::vector<RingPlane> Planes;
  std::vector<int> ByArea;
};
}

#endif
