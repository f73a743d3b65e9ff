// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SectionStack.h
 * @brief How the sections of a shape follow one another along a stack, and how they go on at its
 * ends: as a parabola.
 *
 * The area of a section is a quadratic function of its place for every ellipsoid, cone, cylinder
 * and paraboloid, however these lie, and for no more than three levels of any smooth shape nearly
 * so.
 */
#ifndef recon_SectionStack_h
#define recon_SectionStack_h

#include "Contours/ContourMapping.h"
#include "Contours/ContourSet.h"
#include "Contours/LevelGaps.h"

#include <array>
#include <optional>
#include <vector>

namespace recon
{
/// A section's area at a distance from where it was drawn: Area + Slope t + HalfBend t^2.
struct SectionParabola
{
  double Area = 0; ///< square units, > 0
  double Slope = 0;
  double HalfBend = 0;

  /// Volume up to t.
  double Integral(double t) const;

  /// The least t > 0 with that area, which is less than Area; infinity where there is none.
  double PlaceOf(double area) const;
};

/// Regions of a slab's two levels that joins link to one another.
struct SlabPart
{
  std::array<std::vector<int>, 2> Regions; ///< sorted, of the lower and of the upper level
  std::array<double, 2> Area{ { 0, 0 } };
};

/**
 * @class SectionStack
 * @brief The solid regions of all levels by what is joined to what. A step is 1, up, or -1, down.
 */
class SectionStack
{
public:
  /// All three outlive this.
  SectionStack(const ContourSet& contours, const ContourMapping& mapping, const LevelGaps& gaps);

  const std::vector<SlabPart>& PartsOf(int slab) const { return this->Parts[slab]; }

  /// Whether nothing is joined to a solid region on that side.
  bool Ends(int region, int step) const { return this->PartOf[step > 0 ? 0 : 1][region] < 0; }

  /// What regions of one level become in the slab on that side, if nothing else does and nothing of
  /// them ends.
  const SlabPart* WholePartAt(const std::vector<int>& regions, int step) const;

  /// How far an end may reach: to the next slice, which does not show it, or to where one would be.
  double ReachOf(int level, int step) const;

  /// Of a region that ends on that side: through the three sections behind it, or through two as of
  /// a ball. Nothing where there is none behind, or it was part of another one there.
  std::optional<SectionParabola> ParabolaAtEnd(int region, int step) const;

  static int SlabAt(int level, int step) { return step > 0 ? level : level - 1; }

  /// Whether there is such a slab, and it is bridged.
  bool IsBridged(int slab) const
  {
    return slab >= 0 && slab < static_cast<int>(this->Parts.size()) && !this->Gaps.IsGap[slab];
  }

private:
  void Take(int region, int side, int number, SlabPart& part);

  const ContourSet& Contours;
  const ContourMapping& Mapping;
  const LevelGaps& Gaps;
  std::vector<std::vector<SlabPart>> Parts; ///< by slab
  /// Of a region the part in the slab above it (0: it is on the lower level), and below it.
  std::array<std::vector<int>, 2> PartOf;
};

/// The second derivative along the stack of a section's area on three levels, nearest first.
double BendOf(const std::array<double, 3>& areas, double near, double far);
}

#endif
