// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourChaining.h
 * @brief Closed rings out of closed loops, polylines and loose segments.
 */
#ifndef recon_ContourChaining_h
#define recon_ContourChaining_h

#include "Base/Monitor.h"
#include "Contours/ContourNotes.h"
#include "Contours/ContourSet.h"

#include <vector>

namespace recon
{
/// A closed walk through points of the input; it may still touch or cross itself.
struct Ring
{
  std::vector<int> Points; ///< indices into LoopSoup::Points, at least 3, neighbours differ
  int Source = -1;         ///< input cell (the first, where pieces were chained)
  int Level = -1;          ///< see LoopSoup::Chain::Level; -1 where pieces were chained
};

/// What is left open, chained as far as it goes.
struct OpenLine
{
  std::vector<int> Points; ///< indices into LoopSoup::Points, at least 2
  int Source = -1;
};

struct ChainedRings
{
  std::vector<Ring> Rings;
  std::vector<OpenLine> Open; ///< not named in notes
};

/**
 * Closes what can be closed; what is no ring for other reasons than being open is named in notes.
 *
 * Ends of loose pieces are matched by index first, then by bit-equal coordinates, then within
 * tolerance: ends that share an index belong together even where a contour of another plane passes
 * through the same point. Where more than two pieces meet the walk goes as straight on as it can,
 * and cuts off a ring whenever it comes back to a point that it has passed.
 *
 * @param tolerance largest gap between two ends that is closed, in the input's units
 * @param closeNarrowGaps a line of four points or more whose ends are no farther apart than its
 * points (the median of its edges) was meant to be closed, and is, with a note
 */
ChainedRings ChainRings(const LoopSoup& soup, double tolerance, ContourNotes& notes,
  Monitor& monitor, bool closeNarrowGaps = false);

/// Distance of the line's ends.
double GapOf(const LoopSoup& soup, const OpenLine& line);
}

#endif
