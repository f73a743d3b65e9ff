// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/OpenLines.h"

#include "Base/BoundingBox.h"
#include "Base/Median.h"
#include "Contours/ContourChaining.h"
#include "Contours/ContourNotes.h"
#include "Contours/ContourPlanes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>

namespace recon
{
namespace
{
// Areas that only have to be compared are measured along so many lines.
constexpr int Scanlines = 512;

using Loop2 = std::vector<Point2>;

/// Area inside an odd number of the loops, measured along lines of constant second coordinate.
double EvenOddArea(const std::vector<Loop2>& loops, const Box2& box)
{
  const double step = box.Extent(1) / Scanlines;
  double length = 0;
  std::vector<double> crossings;
  for (int line = 0; line < Scanlines; ++line)
  {
    const double v = box.Low[1] + (line + 0.5) * step;
    crossings.clear();
    for (const Loop2& loop : loops)
    {
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        const Point2& a = loop[i];
        const Point2& b = loop[(i + 1) % loop.size()];
        if ((a[1] > v) != (b[1] > v))
        {
          crossings.push_back(a[0] + (v - a[1]) / (b[1] - a[1]) * (b[0] - a[0]));
        }
      }
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    {
      length += crossings[i + 1] - crossings[i];
    }
  }
  return length * step;
}

/// The border of a rectangle, by the way along it, counterclockwise from its lowest corner.
class Border
{
public:
  explicit Border(const Box2& box) : Box(box) {}

  double Length() const { return 2 * (this->Box.Extent(0) + this->Box.Extent(1)); }

  Point2 At(double way) const
  {
    const double width = this->Box.Extent(0);
    const double height = this->Box.Extent(1);
    if (way <= width)
    {
      return { this->Box.Low[0] + way, this->Box.Low[1] };
    }
    if (way <= width + height)
    {
      return { this->Box.High[0], this->Box.Low[1] + (way - width) };
    }
    if (way <= 2 * width + height)
    {
      return { this->Box.High[0] - (way - width - height), this->Box.High[1] };
    }
    return { this->Box.Low[0], this->Box.High[1] - (way - 2 * width - height) };
  }

  /// The way to the place that is nearest to p, and how far off that is.
  std::pair<double, double> NearestTo(const Point2& p) const
  {
    const double u = std::clamp(p[0], this->Box.Low[0], this->Box.High[0]) - this->Box.Low[0];
    const double v = std::clamp(p[1], this->Box.Low[1], this->Box.High[1]) - this->Box.Low[1];
    const double width = this->Box.Extent(0);
    const double height = this->Box.Extent(1);
    const std::array<std::pair<double, double>, 4> sides{
      { { std::abs(p[1] - this->Box.Low[1]), u }, { std::abs(p[0] - this->Box.High[0]), width + v },
        { std::abs(p[1] - this->Box.High[1]), width + height + (width - u) },
        { std::abs(p[0] - this->Box.Low[0]), 2 * width + height + (height - v) } }
    };
    const auto& best = *std::min_element(sides.begin(), sides.end());
    return { best.second, best.first };
  }

  /// Corners that are passed on the way from one place on to another, past the lowest corner or not.
  std::vector<Point2> CornersBetween(double from, double to, bool pastStart) const
  {
    const double end = pastStart ? to + this->Length() : to;
    const double width = this->Box.Extent(0);
    const double height = this->Box.Extent(1);
    std::vector<Point2> corners;
    for (const double turn : { 0.0, this->Length() })
    {
      for (const double corner : { 0.0, width, width + height, 2 * width + height })
      {
        if (turn + corner > from && turn + corner < end)
        {
          corners.push_back(this->At(corner));
        }
      }
    }
    return corners;
  }

private:
  Box2 Box;
};

/// One end of an open line on the border.
struct LineEnd
{
  double Way = 0;
  std::size_t Line = 0;
  bool IsLast = false; ///< the line's last point, else its first
};

/// A loop of input points (numbers from 0) and corners (-1 - number in Corners).
struct BorderLoop
{
  std::vector<int> Points;
  int Source = -1;
};

/// A plane with its closed contours and its lines that end on the border.
struct BorderPlane
{
  const PlaneOfRings* Plane = nullptr;
  std::vector<Loop2> Closed;
  std::vector<std::size_t> Lines;
  std::vector<LineEnd> Ends; ///< by way
  int Inside = -1; ///< 0 or 1: pieces of the border of that parity are inside; -1: to be decided
};

class BorderCloser
{
public:
  BorderCloser(const LoopSoup& soup, double endTolerance, Monitor& monitor)
    : Soup(soup),
      Progress(monitor),
      Notes(soup)
  {
    for (const LoopSoup::Chain& chain : soup.Chains)
    {
      if (chain.ExclusiveOr)
      {
        this->ExclusiveOrSources.insert(chain.Source);
      }
    }
    ChainedRings chained = ChainRings(soup, endTolerance, this->Notes, monitor, true);
    this->Rings = std::move(chained.Rings);
    this->FirstLine = this->Rings.size();
    for (OpenLine& line : chained.Open)
    {
      this->Rings.push_back({ std::move(line.Points), line.Source, -1 });
    }
  }

  LinesAlongBorder Close()
  {
    this->Result.Soup.Points = this->Soup.Points;
    this->Result.Soup.Levels = this->Soup.Levels;
    this->Result.Soup.Millimetres = this->Soup.Millimetres;
    this->FindPlanes();
    this->Decide();
    std::vector<bool> isClosed(this->Rings.size(), false);
    std::fill_n(isClosed.begin(), this->FirstLine, true);
    for (std::size_t r = 0; r < this->FirstLine; ++r)
    {
      this->AddChain(this->Rings[r].Points, this->Rings[r].Source, true, this->Rings[r].Level);
    }
    for (const BorderPlane& plane : this->Planes)
    {
      this->AddLoops(plane, isClosed);
    }
    for (std::size_t r = this->FirstLine; r < this->Rings.size(); ++r)
    {
      if (!isClosed[r])
      {
        this->AddChain(this->Rings[r].Points, this->Rings[r].Source, false, -1);
      }
    }
    std::optional<PlanarFrame> frame;
    if (!this->Planes.empty())
    {
      frame = this->Planes[0].Plane->Frame;
    }
    // Nothing is lost here but what chaining found unusable, and that has its own sentence.
    this->Result.Report = this->Notes.Sentences(frame, 0);
    return std::move(this->Result);
  }

private:
  bool IsLine(int ring) const { return static_cast<std::size_t>(ring) >= this->FirstLine; }

  Loop2 Flattened(const PlanarFrame& frame, const std::vector<int>& points) const
  {
    Loop2 loop;
    for (int p : points)
    {
      loop.push_back(frame.ToPlane(this->Result.Soup.Points[p]));
    }
    return loop;
  }

  void FindPlanes()
  {
    PlaneOptions options;
    options.Size = Box3::Around(this->Soup.Points).Diagonal();
    ContourNotes elsewhere(this->Soup); // the second time that planes are found has these notes
    this->Grouping = GroupByPlane(this->Soup, this->Rings, options, elsewhere, this->Progress);
    for (const PlaneOfRings& plane : this->Grouping.Planes)
    {
      for (int ring : plane.Rings)
      {
        for (const Point2& p : this->Flattened(plane.Frame, this->Rings[ring].Points))
        {
          this->Box.Add(p);
        }
      }
    }
    for (const PlaneOfRings& plane : this->Grouping.Planes)
    {
      BorderPlane found;
      found.Plane = &plane;
      for (int ring : plane.Rings)
      {
        if (this->IsLine(ring))
        {
          this->AddEnds(static_cast<std::size_t>(ring), found);
        }
        else
        {
          found.Closed.push_back(this->Flattened(plane.Frame, this->Rings[ring].Points));
        }
      }
      std::stable_sort(found.Ends.begin(), found.Ends.end(),
        [](const LineEnd& a, const LineEnd& b) { return a.Way < b.Way; });
      found.Inside = found.Ends.empty() ? 0 : -1;
      this->Planes.push_back(std::move(found));
    }
  }

  void AddEnds(std::size_t line, BorderPlane& plane) const
  {
    const Loop2 points = this->Flattened(plane.Plane->Frame, this->Rings[line].Points);
    std::vector<double> edges;
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      edges.push_back(std::hypot(points[i][0] - points[i - 1][0], points[i][1] - points[i - 1][1]));
    }
    const double allowed = Median(std::move(edges));
    const Border border(this->Box);
    const auto [firstWay, firstOff] = border.NearestTo(points.front());
    const auto [lastWay, lastOff] = border.NearestTo(points.back());
    if (std::max(firstOff, lastOff) <= allowed)
    {
      plane.Lines.push_back(line);
      plane.Ends.push_back({ firstWay, line, false });
      plane.Ends.push_back({ lastWay, line, true });
    }
  }

  // --- which pieces of the border are inside

  /// Contours of a plane as they are where the border's pieces of a parity are inside.
  std::vector<Loop2> RegionOf(const BorderPlane& plane, int inside)
  {
    std::vector<Loop2> loops = plane.Closed;
    for (const BorderLoop& loop : this->Loops(plane, inside))
    {
      Loop2 flat;
      for (int p : loop.Points)
      {
        flat.push_back(
          p >= 0 ? plane.Plane->Frame.ToPlane(this->Soup.Points[p]) : this->Corners[-1 - p]);
      }
      loops.push_back(std::move(flat));
    }
    return loops;
  }

  double Difference(std::vector<Loop2> a, const std::vector<Loop2>& b) const
  {
    a.insert(a.end(), b.begin(), b.end());
    return EvenOddArea(a, this->Box);
  }

  void Decide()
  {
    const auto isDecided = [](const BorderPlane& plane) { return plane.Inside >= 0; };
    if (std::none_of(this->Planes.begin(), this->Planes.end(), isDecided))
    {
      this->DecideSmallest();
    }
    // From what is decided upwards, then downwards.
    for (std::size_t i = 1; i < this->Planes.size(); ++i)
    {
      this->DecideBy(this->Planes[i - 1], this->Planes[i]);
    }
    for (std::size_t i = this->Planes.size(); i-- > 1;)
    {
      this->DecideBy(this->Planes[i], this->Planes[i - 1]);
    }
  }

  void DecideBy(const BorderPlane& decided, BorderPlane& plane)
  {
    if (decided.Inside < 0 || plane.Inside >= 0)
    {
      return;
    }
    const std::vector<Loop2> beside = this->RegionOf(decided, decided.Inside);
    const double even = this->Difference(this->RegionOf(plane, 0), beside);
    const double odd = this->Difference(this->RegionOf(plane, 1), beside);
    plane.Inside = odd < even ? 1 : 0;
  }

  void DecideSmallest()
  {
    BorderPlane* smallest = nullptr;
    double least = 0;
    int inside = 0;
    for (BorderPlane& plane : this->Planes)
    {
      for (int parity : { 0, 1 })
      {
        const double area = EvenOddArea(this->RegionOf(plane, parity), this->Box);
        if (!smallest || area < least)
        {
          smallest = &plane;
          least = area;
          inside = parity;
        }
      }
    }
    if (smallest)
    {
      smallest->Inside = inside;
    }
  }

  // --- loops of lines and pieces of the border

  std::vector<BorderLoop> Loops(const BorderPlane& plane, int inside)
  {
    const int count = static_cast<int>(plane.Ends.size());
    std::vector<bool> used(plane.Ends.size(), false);
    std::vector<BorderLoop> loops;
    for (int start = inside; start < count; start += 2)
    {
      BorderLoop loop;
      // A piece of the border goes from an end to the next one, a line from there to its other end.
      for (int end = start; !used[end];)
      {
        const bool onwards = end % 2 == inside;
        const int next = (end + (onwards ? 1 : count - 1)) % count;
        used[end] = used[next] = true;
        this->AddPiece(plane, end, next, onwards, loop);
        this->AddLine(plane.Ends[next], loop);
        end = OtherEnd(plane, next);
      }
      if (!loop.Points.empty())
      {
        loops.push_back(std::move(loop));
      }
    }
    return loops;
  }

  static int OtherEnd(const BorderPlane& plane, int end)
  {
    for (int i = 0; i < static_cast<int>(plane.Ends.size()); ++i)
    {
      if (i != end && plane.Ends[i].Line == plane.Ends[end].Line)
      {
        return i;
      }
    }
    return end;
  }

  void AddPiece(const BorderPlane& plane, int from, int to, bool onwards, BorderLoop& loop)
  {
    const Border border(this->Box);
    const double a = plane.Ends[from].Way;
    const double b = plane.Ends[to].Way;
    std::vector<Point2> corners =
      onwards ? border.CornersBetween(a, b, to < from) : border.CornersBetween(b, a, from < to);
    if (!onwards)
    {
      std::reverse(corners.begin(), corners.end());
    }
    for (const Point2& corner : corners)
    {
      this->Corners.push_back(corner);
      loop.Points.push_back(-static_cast<int>(this->Corners.size()));
    }
  }

  void AddLine(const LineEnd& from, BorderLoop& loop) const
  {
    const Ring& line = this->Rings[from.Line];
    std::vector<int> points = line.Points;
    if (from.IsLast)
    {
      std::reverse(points.begin(), points.end());
    }
    loop.Points.insert(loop.Points.end(), points.begin(), points.end());
    loop.Source = loop.Source < 0 ? line.Source : std::min(loop.Source, line.Source);
  }

  void AddLoops(const BorderPlane& plane, std::vector<bool>& isClosed)
  {
    for (std::size_t line : plane.Lines)
    {
      isClosed[line] = true;
      const Ring& ring = this->Rings[line];
      this->Notes.Add(ring.Source, ring.Points.size(), ring.Points[0],
        "is open, its ends are " + Text(GapOf(this->Soup, { ring.Points, ring.Source })) +
          " apart; closed along the border of the data, as OpenLines asks");
    }
    for (BorderLoop& loop : this->Loops(plane, std::max(plane.Inside, 0)))
    {
      for (int& p : loop.Points)
      {
        if (p < 0)
        {
          this->Result.Soup.Points.push_back(
            plane.Plane->Frame.ToSpace(this->Corners[-1 - p], plane.Plane->Offset));
          p = static_cast<int>(this->Result.Soup.Points.size()) - 1;
        }
      }
      this->AddChain(loop.Points, loop.Source, true, -1);
    }
  }

  void AddChain(const std::vector<int>& points, int source, bool closed, int level)
  {
    this->Result.Soup.Chains.push_back(
      { points, closed, source, level, this->ExclusiveOrSources.count(source) > 0 });
  }

  const LoopSoup& Soup;
  Monitor& Progress;
  ContourNotes Notes;
  std::set<int> ExclusiveOrSources;
  std::vector<Ring> Rings; ///< closed ones, then lines
  std::size_t FirstLine = 0;
  PlaneGrouping Grouping;
  Box2 Box;
  std::vector<BorderPlane> Planes;
  std::vector<Point2> Corners;
  LinesAlongBorder Result;
};
}

LinesAlongBorder CloseAlongBorder(const LoopSoup& soup, double endTolerance, Monitor& monitor)
{
  return BorderCloser(soup, endTolerance, monitor).Close();
}
}
