// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/ContourChaining.h"

#include "Base/FarthestPoint.h"
#include "Base/Median.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace recon
{
namespace
{
// A line of fewer points encloses nothing that its ends could tell.
constexpr std::size_t FewestOfNarrowGap = 4;

/// An open polyline, with the node at either end.
struct Piece
{
  std::vector<int> Points;
  int Source = -1;
  std::array<int, 2> Node{ -1, -1 };
};

double Distance(const Point3& a, const Point3& b)
{
  return Norm(a - b);
}

/// Walks a graph whose edges are pieces, cutting off rings on the way.
class PieceWalker
{
public:
  PieceWalker(const LoopSoup& soup, std::vector<Piece> pieces)
    : Soup(soup),
      Pieces(std::move(pieces)),
      Used(this->Pieces.size(), false)
  {
    int nodeCount = 0;
    for (const Piece& piece : this->Pieces)
    {
      nodeCount = std::max({ nodeCount, piece.Node[0] + 1, piece.Node[1] + 1 });
    }
    this->At.resize(nodeCount);
    this->Position.assign(nodeCount, -1);
    for (std::size_t i = 0; i < this->Pieces.size(); ++i)
    {
      this->At[this->Pieces[i].Node[0]].push_back({ static_cast<int>(i), 0 });
      this->At[this->Pieces[i].Node[1]].push_back({ static_cast<int>(i), 1 });
    }
  }

  /// Rings are appended to rings; what stays open is returned, chained as far as it goes.
  std::vector<Piece> Walk(std::vector<Ring>& rings, Monitor& monitor)
  {
    // An open tail is walked from its loose end, so that it is reported as one contour.
    for (std::size_t n = 0; n < this->At.size(); ++n)
    {
      if (this->At[n].size() % 2 == 1)
      {
        this->WalkFrom(this->At[n][0], rings);
      }
    }
    for (std::size_t i = 0; i < this->Pieces.size(); ++i)
    {
      if (i % 65536 == 0)
      {
        monitor.Update(0.1, "chaining contours");
      }
      this->WalkFrom({ static_cast<int>(i), 0 }, rings);
    }
    return std::move(this->Open);
  }

private:
  struct Step
  {
    int Id;
    int From; ///< 0: walked from its first point on, 1: from its last
  };

  int StartNode(Step s) const { return this->Pieces[s.Id].Node[s.From]; }
  int EndNode(Step s) const { return this->Pieces[s.Id].Node[1 - s.From]; }

  /// Unit direction in which the step leaves its start, or arrives at its end.
  Vector3 Direction(Step s, bool arriving) const
  {
    const std::vector<int>& p = this->Pieces[s.Id].Points;
    const bool atBack = (s.From == 1) != arriving;
    const Point3& end = this->Soup.Points[atBack ? p.back() : p.front()];
    const Point3& next = this->Soup.Points[atBack ? p[p.size() - 2] : p[1]];
    const Vector3 d = arriving ? end - next : next - end;
    const double length = Norm(d);
    return length > 0 ? (1 / length) * d : d;
  }

  Step StraightestAfter(Step s)
  {
    Step best{ -1, 0 };
    double bestCosine = -2;
    std::vector<Step>& candidates = this->At[this->EndNode(s)];
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                       [this](Step c) { return static_cast<bool>(this->Used[c.Id]); }),
      candidates.end());
    if (candidates.size() == 1)
    {
      return candidates[0];
    }
    const Vector3 arrival = this->Direction(s, true);
    for (Step c : candidates)
    {
      const double cosine = Dot(arrival, this->Direction(c, false));
      if (cosine > bestCosine)
      {
        bestCosine = cosine;
        best = c;
      }
    }
    return best;
  }

  void WalkFrom(Step s, std::vector<Ring>& rings)
  {
    if (this->Used[s.Id])
    {
      return;
    }
    std::vector<Step> path;
    const int origin = this->StartNode(s);
    this->Position[origin] = 0;
    while (s.Id >= 0)
    {
      this->Used[s.Id] = true;
      path.push_back(s);
      const int node = this->EndNode(s);
      int& position = this->Position[node];
      if (position >= 0)
      {
        this->CutRing(path, static_cast<std::size_t>(position), rings);
      }
      else
      {
        position = static_cast<int>(path.size());
      }
      s = this->StraightestAfter(s);
    }
    this->Position[origin] = -1;
    for (Step p : path)
    {
      this->Position[this->EndNode(p)] = -1;
    }
    if (!path.empty())
    {
      this->Open.push_back(this->Join(path, 0, false));
    }
  }

  void CutRing(std::vector<Step>& path, std::size_t from, std::vector<Ring>& rings)
  {
    for (std::size_t i = from; i + 1 < path.size(); ++i)
    {
      this->Position[this->EndNode(path[i])] = -1;
    }
    Piece joined = this->Join(path, from, true);
    rings.push_back({ std::move(joined.Points), joined.Source, -1 });
    path.resize(from);
  }

  Piece Join(const std::vector<Step>& path, std::size_t from, bool closed) const
  {
    Piece joined;
    for (std::size_t i = from; i < path.size(); ++i)
    {
      const Piece& piece = this->Pieces[path[i].Id];
      std::vector<int> points = piece.Points;
      if (path[i].From == 1)
      {
        std::reverse(points.begin(), points.end());
      }
      // The first point of a piece is the last of the one before: the earlier one stays.
      const auto skip = static_cast<std::ptrdiff_t>(joined.Points.empty() ? 0 : 1);
      joined.Points.insert(joined.Points.end(), points.begin() + skip, points.end());
      joined.Source = joined.Source < 0 ? piece.Source : std::min(joined.Source, piece.Source);
    }
    if (closed)
    {
      joined.Points.pop_back();
    }
    return joined;
  }

  const LoopSoup& Soup;
  std::vector<Piece> Pieces;
  std::vector<bool> Used;
  std::vector<std::vector<Step>> At;
  std::vector<int> Position;
  std::vector<Piece> Open;
};

/// Nodes are the indices of the end points, made small.
void NumberByIndex(std::vector<Piece>& pieces)
{
  std::vector<int> ends;
  for (const Piece& piece : pieces)
  {
    ends.push_back(piece.Points.front());
    ends.push_back(piece.Points.back());
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  const auto number = [&ends](int p)
  { return static_cast<int>(std::lower_bound(ends.begin(), ends.end(), p) - ends.begin()); };
  for (Piece& piece : pieces)
  {
    piece.Node = { number(piece.Points.front()), number(piece.Points.back()) };
  }
}

/// Nodes are the distinct coordinates of the end points.
void NumberByCoordinates(const LoopSoup& soup, std::vector<Piece>& pieces)
{
  std::vector<Point3> ends;
  for (const Piece& piece : pieces)
  {
    ends.push_back(soup.Points[piece.Points.front()]);
    ends.push_back(soup.Points[piece.Points.back()]);
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  const auto number = [&](int p)
  {
    return static_cast<int>(
      std::lower_bound(ends.begin(), ends.end(), soup.Points[p]) - ends.begin());
  };
  for (Piece& piece : pieces)
  {
    piece.Node = { number(piece.Points.front()), number(piece.Points.back()) };
  }
}

/// Pairs of loose ends within tolerance, nearest first, become one node each.
class EndMatcher
{
public:
  EndMatcher(const LoopSoup& soup, std::vector<Piece>& pieces, double tolerance)
    : Soup(soup),
      Pieces(pieces),
      Tolerance(tolerance)
  {
  }

  void Number()
  {
    for (std::size_t i = 0; i < this->Pieces.size(); ++i)
    {
      this->Pieces[i].Node = { static_cast<int>(2 * i), static_cast<int>(2 * i + 1) };
    }
    if (!(this->Tolerance > 0))
    {
      return;
    }
    std::vector<std::tuple<double, int, int>> pairs = this->NearPairs();
    std::sort(pairs.begin(), pairs.end());
    std::vector<bool> taken(2 * this->Pieces.size(), false);
    for (const auto& [distance, a, b] : pairs)
    {
      if (!taken[a] && !taken[b])
      {
        taken[a] = taken[b] = true;
        this->Pieces[b / 2].Node[b % 2] = a;
      }
    }
  }

private:
  using Cell = std::array<std::int64_t, 3>;

  const Point3& End(int e) const
  {
    const std::vector<int>& p = this->Pieces[e / 2].Points;
    return this->Soup.Points[e % 2 == 0 ? p.front() : p.back()];
  }

  Cell CellOf(const Point3& p) const
  {
    // The tolerance is a fraction of the size, but coordinates may lie far from the origin.
    const Point3& o = this->End(0);
    Cell c{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      c[k] = static_cast<std::int64_t>(std::floor((p[k] - o[k]) / this->Tolerance));
    }
    return c;
  }

  std::vector<std::tuple<double, int, int>> NearPairs() const
  {
    std::map<Cell, std::vector<int>> grid;
    std::vector<std::tuple<double, int, int>> pairs;
    for (int e = 0; e < static_cast<int>(2 * this->Pieces.size()); ++e)
    {
      const Cell c = this->CellOf(this->End(e));
      for (int n = 0; n < 27; ++n)
      {
        const auto found = grid.find({ c[0] + n % 3 - 1, c[1] + n / 3 % 3 - 1, c[2] + n / 9 - 1 });
        if (found == grid.end())
        {
          continue;
        }
        for (int other : found->second)
        {
          this->AddPair(other, e, pairs);
        }
      }
      grid[c].push_back(e);
    }
    return pairs;
  }

  void AddPair(int a, int b, std::vector<std::tuple<double, int, int>>& pairs) const
  {
    const double distance = Distance(this->End(a), this->End(b));
    const bool ownSegment = a / 2 == b / 2 && this->Pieces[a / 2].Points.size() < 4;
    if (distance <= this->Tolerance && !ownSegment)
    {
      pairs.emplace_back(distance, a, b);
    }
  }

  const LoopSoup& Soup;
  std::vector<Piece>& Pieces;
  double Tolerance;
};

/// A segment that is given twice is one segment: two faces of a mesh that was cut along their edge.
void DropRepeatedSegments(std::vector<Piece>& pieces, ContourNotes& notes)
{
  std::set<std::pair<int, int>> seen;
  std::vector<Piece> kept;
  std::size_t dropped = 0;
  int source = -1;
  int place = -1;
  for (Piece& piece : pieces)
  {
    const std::pair<int, int> nodes = std::minmax(piece.Node[0], piece.Node[1]);
    if (piece.Points.size() == 2 && !seen.insert(nodes).second)
    {
      source = dropped == 0 ? piece.Source : source;
      place = dropped == 0 ? piece.Points[0] : place;
      ++dropped;
      continue;
    }
    kept.push_back(std::move(piece));
  }
  if (dropped > 0)
  {
    notes.Add(source, 2, place,
      Counted(dropped, "loose segment") + ", this being the first, repeated another one and " +
        (dropped == 1 ? "was" : "were") + " left out");
  }
  pieces = std::move(kept);
}

bool Usable(const LoopSoup& soup, const LoopSoup::Chain& chain, ContourNotes& notes)
{
  int good = -1;
  const char* bad = nullptr;
  for (int p : chain.Points)
  {
    if (p < 0 || p >= static_cast<int>(soup.Points.size()))
    {
      bad = "refers to a point that does not exist; left out";
      break;
    }
    const Point3& x = soup.Points[p];
    if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
    {
      bad = "has a coordinate that is not a finite number; left out";
    }
    else if (Norm(x) > FarthestPoint)
    {
      bad = "has a coordinate beyond 1e60; left out";
    }
    else
    {
      good = p;
    }
  }
  if (bad)
  {
    notes.Add(chain.Source, chain.Points.size(), good, bad);
  }
  return !bad;
}

/// Takes out points that equal the one before; true where the ring is still a ring.
bool CleanRing(const LoopSoup& soup, Ring& ring, ContourNotes& notes)
{
  const auto same = [&soup](int a, int b) { return soup.Points[a] == soup.Points[b]; };
  std::vector<int>& p = ring.Points;
  const std::size_t given = p.size();
  const int place = p.empty() ? -1 : p[0];
  // That the first point is repeated at the end is a way of writing, not a fault.
  if (p.size() > 1 && same(p.front(), p.back()))
  {
    p.pop_back();
  }
  const std::size_t before = p.size();
  p.erase(std::unique(p.begin(), p.end(), same), p.end());
  while (p.size() > 1 && same(p.front(), p.back()))
  {
    p.pop_back();
  }
  const std::size_t removed = before - p.size();
  if (p.size() < 3)
  {
    notes.Add(ring.Source, given, place,
      "has only " + Counted(p.size(), "distinct point") + ", which enclose nothing; left out");
    return false;
  }
  if (removed > 0)
  {
    notes.Add(ring.Source, given, place,
      Counted(removed, "point") + " equal to the one before " + (removed == 1 ? "was" : "were") +
        " removed");
  }
  return true;
}

/// Closed chains go to rings, open ones to pieces, what is neither to notes.
void Separate(
  const LoopSoup& soup, std::vector<Ring>& rings, std::vector<Piece>& pieces, ContourNotes& notes)
{
  for (const LoopSoup::Chain& chain : soup.Chains)
  {
    if (!Usable(soup, chain, notes))
    {
      continue;
    }
    const std::vector<int>& p = chain.Points;
    const bool returns = p.size() > 1 && soup.Points[p.front()] == soup.Points[p.back()];
    if (chain.Closed || returns || p.size() < 2)
    {
      rings.push_back({ p, chain.Source, chain.Level });
      continue;
    }
    pieces.push_back({ p, chain.Source, {} });
  }
}

/// Closes lines whose ends are no farther apart than their points.
void CloseNarrowGaps(
  const LoopSoup& soup, std::vector<OpenLine>& open, std::vector<Ring>& rings, ContourNotes& notes)
{
  const auto closes = [&](const OpenLine& line)
  {
    if (line.Points.size() < FewestOfNarrowGap)
    {
      return false;
    }
    std::vector<double> edges;
    for (std::size_t i = 1; i < line.Points.size(); ++i)
    {
      edges.push_back(Distance(soup.Points[line.Points[i - 1]], soup.Points[line.Points[i]]));
    }
    const double spacing = Median(std::move(edges));
    const double gap = GapOf(soup, line);
    // Equal but for rounding is no farther.
    if (gap > spacing * (1 + 1e-9))
    {
      return false;
    }
    notes.Add(line.Source, line.Points.size(), line.Points[0],
      "was closed by a straight line, as its ends are " + Text(gap) +
        " apart, no more than its points (" + Text(spacing) + ")");
    rings.push_back({ line.Points, line.Source, -1 });
    return true;
  };
  open.erase(std::remove_if(open.begin(), open.end(), closes), open.end());
}
}

double GapOf(const LoopSoup& soup, const OpenLine& line)
{
  return Distance(soup.Points[line.Points.front()], soup.Points[line.Points.back()]);
}

ChainedRings ChainRings(const LoopSoup& soup, double tolerance, ContourNotes& notes,
  Monitor& monitor, bool closeNarrowGaps)
{
  monitor.Update(0, "chaining contours");
  std::vector<Ring> rings;
  std::vector<Piece> pieces;
  Separate(soup, rings, pieces, notes);

  if (!pieces.empty())
  {
    NumberByIndex(pieces);
    DropRepeatedSegments(pieces, notes);
    pieces = PieceWalker(soup, std::move(pieces)).Walk(rings, monitor);
  }
  if (!pieces.empty())
  {
    NumberByCoordinates(soup, pieces);
    DropRepeatedSegments(pieces, notes);
    pieces = PieceWalker(soup, std::move(pieces)).Walk(rings, monitor);
  }
  if (!pieces.empty())
  {
    EndMatcher(soup, pieces, tolerance).Number();
    const std::size_t before = rings.size();
    pieces = PieceWalker(soup, std::move(pieces)).Walk(rings, monitor);
    for (std::size_t i = before; i < rings.size(); ++i)
    {
      notes.Add(rings[i].Source, rings[i].Points.size(), rings[i].Points[0],
        "was closed where ends lay within " + Text(tolerance) + " of each other");
    }
  }
  std::vector<OpenLine> open;
  for (Piece& piece : pieces)
  {
    open.push_back({ std::move(piece.Points), piece.Source });
  }
  if (closeNarrowGaps)
  {
    CloseNarrowGaps(soup, open, rings, notes);
  }

  std::stable_sort(
    rings.begin(), rings.end(), [](const Ring& a, const Ring& b) { return a.Source < b.Source; });
  rings.erase(std::remove_if(rings.begin(), rings.end(),
                [&](Ring& ring) { return !CleanRing(soup, ring, notes); }),
    rings.end());
  return { std::move(rings), std::move(open) };
}
}
