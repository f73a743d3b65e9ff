// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/Specks.h"

#include "Base/Text.h"
#include "Contours/RingPlane.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace recon
{
namespace
{
/// So much smaller than any that was drawn is not what somebody would have drawn.
constexpr double PartOfDrawn = 0.5;
}

std::string LeaveOutSpecks(double smallest, LoopSoup& soup)
{
  const auto isSpeck = [&](const LoopSoup::Chain& chain)
  { return chain.Closed && Norm(NewellArea(soup, chain.Points)) < smallest; };
  const auto kept = std::remove_if(soup.Chains.begin(), soup.Chains.end(), isSpeck);
  const auto specks = static_cast<std::size_t>(soup.Chains.end() - kept);
  soup.Chains.erase(kept, soup.Chains.end());
  if (specks == 0)
  {
    return {};
  }
  return Counted(specks, "computed contour") + " of less than " + Text(smallest) +
    " square units left out, as nobody drew one so small.";
}

double SpeckArea(double pixel, double smallestDrawn)
{
  return std::min(pixel, PartOfDrawn * smallestDrawn);
}

double SmallestArea(const ContourSet& contours)
{
  double smallest = std::numeric_limits<double>::infinity();
  for (const Contour& contour : contours.Contours)
  {
    smallest = std::min(smallest, std::abs(contour.SignedArea));
  }
  return contours.Contours.empty() ? 0 : smallest;
}
}
