// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/LevelGaps.h"

#include "Base/Median.h"

#include <algorithm>

namespace recon
{
namespace
{
/// The thickness of the slab beside another, and of the one beyond it; 0 where there is none.
struct Neighbour
{
  double Thickness = 0;
  double Beyond = 0;

  bool Counts(double maximumGap, double median) const
  {
    return this->Thickness > 0 &&
      this->Thickness <= maximumGap * (this->Beyond > 0 ? this->Beyond : median);
  }
};

Neighbour NeighbourAt(const std::vector<double>& thickness, int slab, int step)
{
  const auto at = [&thickness](int i)
  { return i >= 0 && i < static_cast<int>(thickness.size()) ? thickness[i] : 0.0; };
  return { at(slab + step), at(slab + 2 * step) };
}

double SpacingBeside(
  const std::vector<double>& thickness, int slab, double maximumGap, double median)
{
  const Neighbour below = NeighbourAt(thickness, slab, -1);
  const Neighbour above = NeighbourAt(thickness, slab, 1);
  double spacing = 0;
  for (const Neighbour& neighbour : { below, above })
  {
    spacing =
      neighbour.Counts(maximumGap, median) ? std::max(spacing, neighbour.Thickness) : spacing;
  }
  if (spacing > 0)
  {
    return spacing;
  }
  return below.Thickness > 0 && above.Thickness > 0 ? std::min(below.Thickness, above.Thickness)
                                                    : below.Thickness + above.Thickness;
}
}

LevelGaps FindLevelGaps(const ContourSet& contours, double maximumGap)
{
  LevelGaps gaps;
  for (std::size_t l = 1; l < contours.Levels.size(); ++l)
  {
    gaps.Thickness.push_back(contours.Levels[l].Offset - contours.Levels[l - 1].Offset);
  }
  const double median = Median(gaps.Thickness);
  for (std::size_t slab = 0; slab < gaps.Thickness.size(); ++slab)
  {
    const double usual = SpacingBeside(gaps.Thickness, static_cast<int>(slab), maximumGap, median);
    // A gap of exactly so many spacings is bridged, also where offsets are rounded decimals.
    const bool tooWide =
      maximumGap > 0 && usual > 0 && gaps.Thickness[slab] > maximumGap * usual * (1 + 1e-9);
    gaps.Usual.push_back(usual);
    gaps.IsGap.push_back(tooWide ? 1 : 0);
  }
  return gaps;
}
}
