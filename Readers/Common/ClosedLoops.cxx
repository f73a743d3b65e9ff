// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/ClosedLoops.h"

#include "Contours/ContourChaining.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace recon
{
namespace
{
/// Edges by the coordinates of their ends: chaining joins ends that differ in index only.
class EdgeSet
{
public:
  explicit EdgeSet(const LoopSoup& soup) : Soup(soup) {}
  void Add(int a, int b) { this->Edges.insert(this->Key(a, b)); }
  bool Has(int a, int b) const { return this->Edges.count(this->Key(a, b)) > 0; }
  bool IsPoint(int a, int b) const { return this->At(a) == this->At(b); }

private:
  using Edge = std::pair<Point3, Point3>;
  const Point3& At(int point) const { return this->Soup.Points[static_cast<std::size_t>(point)]; }
  Edge Key(int a, int b) const { return std::minmax(this->At(a), this->At(b)); }

  const LoopSoup& Soup;
  std::set<Edge> Edges;
};

/// @throws Error naming the first piece that is in no ring.
void CheckAllClosed(
  const LoopSoup& pieces, const std::vector<Ring>& rings, const std::string& fileHolds)
{
  EdgeSet closed(pieces);
  for (const Ring& ring : rings)
  {
    for (std::size_t i = 0; i < ring.Points.size(); ++i)
    {
      closed.Add(ring.Points[i], ring.Points[(i + 1) % ring.Points.size()]);
    }
  }
  for (const LoopSoup::Chain& piece : pieces.Chains)
  {
    for (std::size_t i = 0; i + 1 < piece.Points.size(); ++i)
    {
      const int a = piece.Points[i];
      const int b = piece.Points[i + 1];
      if (!closed.IsPoint(a, b) && !closed.Has(a, b))
      {
        throw Error("Cannot write the contours: the line of cell " + std::to_string(piece.Source) +
          " does not close, and " + fileHolds + " closed contours only.");
      }
    }
  }
}
}

LoopSoup CloseLoops(
  LoopSoup soup, const std::string& fileHolds, int& looseVertices, Monitor& monitor)
{
  LoopSoup closed;
  LoopSoup pieces;
  for (LoopSoup::Chain& chain : soup.Chains)
  {
    if (chain.Closed)
    {
      closed.Chains.push_back(std::move(chain));
    }
    else if (chain.Points.size() < 2)
    {
      ++looseVertices;
    }
    else
    {
      pieces.Chains.push_back(std::move(chain));
    }
  }
  pieces.Points = std::move(soup.Points);
  ContourNotes notes(pieces); // what they say is an error here, see CheckAllClosed
  std::vector<Ring> rings = ChainRings(pieces, 0, notes, monitor).Rings;
  CheckAllClosed(pieces, rings, fileHolds);
  for (Ring& ring : rings)
  {
    closed.Chains.push_back({ std::move(ring.Points), true, ring.Source });
  }
  closed.Points = std::move(pieces.Points);
  return closed;
}
}
