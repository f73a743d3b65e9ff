// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/BorderWalks.h"

#include "Planar/TurnOrder.h"

#include <cstddef>

namespace recon
{
void BorderWalks::Add(int from, int to)
{
  this->Outgoing[from].push_back(static_cast<int>(this->Edges.size()));
  ++this->Balance[from];
  --this->Balance[to];
  this->Edges.push_back({ from, to, false });
}

std::vector<BorderWalk> BorderWalks::Walk()
{
  std::vector<BorderWalk> walks;
  for (const auto& [point, balance] : this->Balance)
  {
    if (balance <= 0)
    {
      continue;
    }
    int left = balance;
    for (int e : this->Outgoing.at(point))
    {
      if (left > 0 && !this->Edges[e].Used)
      {
        --left;
        walks.push_back(this->WalkFrom(e, true));
      }
    }
  }
  for (std::size_t e = 0; e < this->Edges.size(); ++e)
  {
    if (!this->Edges[e].Used)
    {
      walks.push_back(this->WalkFrom(static_cast<int>(e), false));
    }
  }
  return walks;
}

BorderWalk BorderWalks::WalkFrom(int first, bool isOpen)
{
  BorderWalk walk;
  int last = first;
  for (int e = first; e >= 0;)
  {
    this->Edges[e].Used = true;
    walk.Points.push_back(this->Edges[e].From);
    last = e;
    e = this->NextAfter(this->Edges[e], isOpen ? -1 : first);
    if (e == first)
    {
      break;
    }
  }
  const int end = this->Edges[last].To;
  walk.Closed = end == this->Edges[first].From;
  if (!walk.Closed)
  {
    walk.Points.push_back(end);
  }
  return walk;
}

/// Clockwise from where one came from: the next edge there bounds the same corner of the region.
/// The first edge of the walk counts as well, -1 for one that is open; -1: none is left.
int BorderWalks::NextAfter(const HalfEdge& last, int first) const
{
  const auto found = this->Outgoing.find(last.To);
  if (found == this->Outgoing.end())
  {
    return -1;
  }
  int best = -1;
  for (int e : found->second)
  {
    if (this->Edges[e].Used && e != first)
    {
      continue;
    }
    if (best < 0 ||
      ComesFirstClockwise(this->At(last.To), this->At(last.From), this->At(this->Edges[e].To),
        this->At(this->Edges[best].To)))
    {
      best = e;
    }
  }
  return best;
}
}
