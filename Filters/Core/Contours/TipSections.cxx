// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/TipSections.h"

#include "Base/Predicates.h"
#include "Base/Text.h"
#include "Contours/RingPlane.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace recon
{
namespace
{
/// What is nearer than this part of the size of the data lies in one plane.
constexpr double SamePart = 1e-6;
/// Points are one, or in line, up to rounding: a ring that has any width is a contour.
constexpr double RoundingPart = 1e-12;
/// A tip farther than this many spacings of the last two levels is something else.
constexpr double MostSpacings = 1.5;
/// Width of the triangle for a point, as a part of its distance from the next level.
constexpr double WidthOfPoint = 1e-4;
/// Width of the triangle for a line, as a part of its length, and the most of that distance.
constexpr double WidthOfLine = 0.005;
constexpr double MostWidthOfLine = 0.1;
/// Rings whose normals differ by more than this (a sine) are no stack.
constexpr double LargestLean = 0.02;

/// All rings of one plane.
struct RingLevel
{
  double Offset = 0;
  std::vector<std::size_t> Chains;
};

/// What lies beyond the rings on one plane.
struct Beyond
{
  double Offset = 0;
  std::vector<std::size_t> Chains;
  std::vector<int> Points;
};

class Finder
{
public:
  Finder(const LoopSoup& soup, double size)
    : Soup(soup),
      Same(SamePart * size),
      Rounding(RoundingPart * size)
  {
  }

  TipSections Find()
  {
    TipSections found{ this->Soup, {} };
    if (!this->IsUsable() || !this->FindRings())
    {
      return found;
    }
    std::vector<std::size_t> gone;
    for (const bool above : { false, true })
    {
      const std::optional<Beyond> section = this->SectionBeyond(above);
      if (section && this->DrawTip(*section, above, found))
      {
        gone.insert(gone.end(), section->Chains.begin() + 1, section->Chains.end());
      }
    }
    std::sort(gone.begin(), gone.end());
    for (auto chain = gone.rbegin(); chain != gone.rend(); ++chain)
    {
      found.Soup.Chains.erase(found.Soup.Chains.begin() + static_cast<std::ptrdiff_t>(*chain));
    }
    return found;
  }

private:
  /// Bad points are the business of the chaining, which names them.
  bool IsUsable() const
  {
    return std::all_of(this->Soup.Chains.begin(), this->Soup.Chains.end(),
      [&](const LoopSoup::Chain& chain)
      {
        return std::all_of(chain.Points.begin(), chain.Points.end(),
          [&](int p)
          {
            return p >= 0 && p < static_cast<int>(this->Soup.Points.size()) &&
              std::isfinite(Norm(this->Soup.Points[p]));
          });
      });
  }

  bool IsClosed(const LoopSoup::Chain& chain) const
  {
    return chain.Points.size() >= 3 &&
      (chain.Closed ||
        Norm(this->At(chain.Points.front()) - this->At(chain.Points.back())) <= this->Same);
  }

  const Point3& At(int p) const { return this->Soup.Points[p]; }

  /// The two points of some that are about farthest apart.
  std::pair<int, int> FarthestOf(const std::vector<int>& points) const
  {
    const auto farthestFrom = [&](int from)
    {
      return *std::max_element(points.begin(), points.end(),
        [&](int a, int b)
        { return Norm(this->At(a) - this->At(from)) < Norm(this->At(b) - this->At(from)); });
    };
    const int a = farthestFrom(points.front());
    return { a, farthestFrom(a) };
  }

  /// One point, or in line?
  bool HasNoWidth(const std::vector<int>& points) const
  {
    const auto [a, b] = this->FarthestOf(points);
    return std::all_of(points.begin(), points.end(),
      [&, a = a, b = b](int p)
      {
        return SquaredDistanceToSegment(this->At(p), this->At(a), this->At(b)) <=
          this->Rounding * this->Rounding;
      });
  }

  /// Sorts the rings into levels along their common normal; false where they are no stack.
  bool FindRings()
  {
    Vector3 largest{ 0, 0, 0 };
    std::vector<std::size_t> rings;
    for (std::size_t c = 0; c < this->Soup.Chains.size(); ++c)
    {
      const LoopSoup::Chain& chain = this->Soup.Chains[c];
      if (this->IsClosed(chain) && !this->HasNoWidth(chain.Points))
      {
        rings.push_back(c);
        const Vector3 area = NewellArea(this->Soup, chain.Points);
        largest = Norm(area) > Norm(largest) ? area : largest;
      }
    }
    if (rings.empty() || !(Norm(largest) > 0))
    {
      return false;
    }
    this->Frame = PlanarFrame::About(NearlyAnAxis((1 / Norm(largest)) * largest));
    this->IsRing.assign(this->Soup.Chains.size(), 0);
    for (std::size_t c : rings)
    {
      this->IsRing[c] = 1;
      const Vector3 area = NewellArea(this->Soup, this->Soup.Chains[c].Points);
      if (Norm(Cross(area, this->Frame.Normal)) > LargestLean * Norm(area))
      {
        return false;
      }
      this->AddToLevel(c);
    }
    std::sort(this->Levels.begin(), this->Levels.end(),
      [](const RingLevel& a, const RingLevel& b) { return a.Offset < b.Offset; });
    return true;
  }

  /// A coordinate axis up to rounding is that axis, so that nothing is rounded along it.
  static Vector3 NearlyAnAxis(const Vector3& unit)
  {
    Vector3 axis = unit;
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (std::abs(unit[k]) > 1 - 1e-12)
      {
        axis = { 0, 0, 0 };
        axis[k] = 1;
      }
    }
    return axis;
  }

  void AddToLevel(std::size_t chain)
  {
    const double offset = this->Frame.OffsetOf(this->At(this->Soup.Chains[chain].Points[0]));
    const auto level = std::find_if(this->Levels.begin(), this->Levels.end(),
      [&](const RingLevel& l) { return std::abs(l.Offset - offset) <= this->Same; });
    if (level == this->Levels.end())
    {
      this->Levels.push_back({ offset, { chain } });
      return;
    }
    level->Chains.push_back(chain);
  }

  const RingLevel& EndLevel(bool above) const
  {
    return above ? this->Levels.back() : this->Levels.front();
  }

  /// Distance of the outermost two levels; 0 where there is one only.
  double SpacingAt(bool above) const
  {
    const std::size_t count = this->Levels.size();
    if (count < 2)
    {
      return 0;
    }
    return above ? this->Levels[count - 1].Offset - this->Levels[count - 2].Offset
                 : this->Levels[1].Offset - this->Levels[0].Offset;
  }

  /// The only plane beyond the rings on one side, if there is one.
  std::optional<Beyond> SectionBeyond(bool above) const
  {
    std::optional<Beyond> section;
    const double end = this->EndLevel(above).Offset;
    for (std::size_t c = 0; c < this->Soup.Chains.size(); ++c)
    {
      for (int p : this->Soup.Chains[c].Points)
      {
        const double offset = this->Frame.OffsetOf(this->At(p));
        if (this->IsRing[c] != 0 ||
          (above ? offset <= end + this->Same : offset >= end - this->Same))
        {
          continue;
        }
        if (section && std::abs(section->Offset - offset) > this->Same)
        {
          return std::nullopt;
        }
        section = section ? section : Beyond{ offset, {}, {} };
        section->Points.push_back(p);
        if (section->Chains.empty() || section->Chains.back() != c)
        {
          section->Chains.push_back(c);
        }
      }
    }
    return section;
  }

  /// Even-odd over the rings of a level, seen along the normal.
  bool IsWithin(const RingLevel& level, const Point3& x) const
  {
    const Point2 p = this->Frame.ToPlane(x);
    bool inside = false;
    for (std::size_t c : level.Chains)
    {
      const std::vector<int>& ring = this->Soup.Chains[c].Points;
      for (std::size_t i = 0; i < ring.size(); ++i)
      {
        const Point2 a = this->Frame.ToPlane(this->At(ring[i]));
        const Point2 b = this->Frame.ToPlane(this->At(ring[(i + 1) % ring.size()]));
        // A ray to the right crosses an edge that runs up with p on its left, or down on its right.
        const bool up = a[1] <= p[1];
        if (up != (b[1] <= p[1]) && Orientation2(a, b, p) == (up ? 1 : -1))
        {
          inside = !inside;
        }
      }
    }
    return inside;
  }

  bool DrawTip(const Beyond& section, bool above, TipSections& found) const
  {
    const RingLevel& next = this->EndLevel(above);
    const double distance = std::abs(section.Offset - next.Offset);
    const double spacing = this->SpacingAt(above);
    if (!this->HasNoWidth(section.Points) || (spacing > 0 && distance > MostSpacings * spacing))
    {
      return false;
    }
    const auto [a, b] = this->FarthestOf(section.Points);
    const double length = Norm(this->At(b) - this->At(a));
    const Point3 middle = 0.5 * (this->At(a) + this->At(b));
    if (!this->IsWithin(next, middle))
    {
      return false;
    }
    const bool isPoint = length <= this->Rounding;
    const double width = isPoint ? WidthOfPoint * distance
                                 : std::min(WidthOfLine * length, MostWidthOfLine * distance);
    const Vector3 along = isPoint ? this->Frame.U : (1 / length) * (this->At(b) - this->At(a));
    const Vector3 across = isPoint ? this->Frame.V : Cross(this->Frame.Normal, along);
    LoopSoup::Chain& chain = found.Soup.Chains[section.Chains.front()];
    const int added = static_cast<int>(found.Soup.Points.size());
    found.Soup.Points.push_back(middle + width * across);
    chain.Points = { a, b, added };
    if (isPoint)
    {
      found.Soup.Points.push_back(this->At(a) + width * along);
      chain.Points = { a, added + 1, added };
    }
    chain.Closed = true;
    found.Report.push_back("The section at offset " + Text(section.Offset) +
      (isPoint ? " is one point" : " is a line") +
      ": taken for the end of the shape, and drawn as a "
      "triangle " +
      Text(width) + " wide.");
    return true;
  }

  const LoopSoup& Soup;
  double Same;
  double Rounding;
  PlanarFrame Frame;
  std::vector<unsigned char> IsRing; ///< a chain
  std::vector<RingLevel> Levels;     ///< by increasing offset
};
}

TipSections DrawTips(const LoopSoup& soup, double size)
{
  return Finder(soup, size).Find();
}
}
