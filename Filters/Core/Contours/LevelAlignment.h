// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file LevelAlignment.h
 * @brief Shifts levels onto one another where sections of one oblique shape hardly overlap.
 *
 * Overlap decides what belongs together, and the Voronoi diagrams of two levels are laid over one
 * another: both suppose that the shape runs about along the normal. The sections of a swept wing, a
 * twisted blade, a thin tube or an oblique shaft lie beside one another instead. If each level is
 * shifted in its plane so that the sections that are to be joined have one centroid, a slab is
 * sheared: an affine map, under which tetrahedra stay tetrahedra and never overlap. So the method
 * works on the shifted levels, and its result is shifted back, height by height. Contour vertices
 * themselves are not touched: they are given out as they came.
 */
#ifndef recon_LevelAlignment_h
#define recon_LevelAlignment_h

#include "Contours/ContourSet.h"

#include <string>
#include <utility>
#include <vector>

namespace recon
{
/// When two neighbouring levels are shifted onto one another.
enum class LevelAlignmentMode
{
  /// Never, but for a forced join of the only two, where they do not overlap.
  Off,
  /// Where both levels have one outer contour each, of comparable size, these share less than half
  /// of the smaller one, and the line through their centroids leans by less than 45 degrees from
  /// the normal.
  Automatic,
  /// Wherever both levels have one outer contour each, whatever they share.
  On
};

/// How far each level is shifted; empty where none is.
struct LevelAlignment
{
  std::vector<Point2> Shift;       ///< by level, in the units of the contours
  std::vector<double> Offset;      ///< of the levels
  std::vector<std::string> Report; ///< a sentence for what was shifted, or might have to be

  bool IsEmpty() const { return this->Shift.empty(); }

  /// What the method made of place p at a height, put back where it belongs: heights between two
  /// levels are sheared in proportion, those beyond the first and the last move along with these.
  Point2 Undo(const Point2& p, double height) const;
};

/**
 * Decide about every slab of a Parallel set.
 *
 * @param forcedJoins pairs of contours of neighbouring levels that are to be joined; where they are
 * the only outer contours of their levels and do not overlap, they are shifted onto one another
 */
LevelAlignment FindLevelAlignment(const ContourSet& contours, LevelAlignmentMode mode,
  const std::vector<std::pair<int, int>>& forcedJoins);

/// The set with shifted planar coordinates; Points stay as they are.
ContourSet Aligned(const ContourSet& contours, const LevelAlignment& alignment);
}

#endif
