// SPDX-License-Identifier: GPL-3.0-or-later
#include "BRep/BRepContours.h"

#include "Contours/ContourChaining.h"

#include <utility>

namespace recon
{
namespace
{
SpaceLoop InSpace(const LoopSoup& soup, const std::vector<int>& points)
{
  SpaceLoop loop;
  for (const int point : points)
  {
    loop.push_back(soup.Points[point]);
  }
  return loop;
}
}

std::vector<SpaceLoop> ClosedSpaceLoops(LoopSoup soup, Monitor& monitor)
{
  std::vector<SpaceLoop> loops;
  LoopSoup pieces;
  for (LoopSoup::Chain& chain : soup.Chains)
  {
    if (chain.Closed)
    {
      loops.push_back(InSpace(soup, chain.Points));
    }
    else if (chain.Points.size() > 1)
    {
      pieces.Chains.push_back(std::move(chain));
    }
  }
  if (pieces.Chains.empty())
  {
    return loops;
  }
  pieces.Points = std::move(soup.Points);
  ContourNotes notes(pieces);
  const ChainedRings chained = ChainRings(pieces, 0, notes, monitor);
  for (const Ring& ring : chained.Rings)
  {
    loops.push_back(InSpace(pieces, ring.Points));
  }
  return loops;
}
}
