// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file NestedStacks.h
 * @brief Random nested stacks as they are drawn in the wild, through the whole method with random
 * options.
 *
 * Beside what RandomStack gives: holes in holes to any depth, branchings of any kind, contours that
 * touch, overlap or cross (so that the hole rule matters), outlines that repeat from level to
 * level, cocircular points, either direction of drawing, slices of any spacing with gaps, tilted
 * planes, coordinates far from the origin.
 *
 * A failure names its seed and how to run that one alone.
 */
#ifndef recon_Testing_NestedStacks_h
#define recon_Testing_NestedStacks_h

#include "PolyhedralShapes.h"
#include "SurfaceInvariants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace recon::testing
{
/// Everything that a seed decides, but the overrides.
class NestedStack
{
public:
  LoopSoup Soup;
  ContourSetOptions Cleaning;
  PolyhedralOptions Options;

  explicit NestedStack(unsigned seed) : Random(seed)
  {
    this->Shape = static_cast<ShapeType>(this->Draw(0, 3));
    this->Places = this->Draw(1, 3);
    // Neighbours of reach 1 are apart, touch, or overlap.
    this->Pitch = this->OneOf({ 2.1, 2.1, 2.0, 1.8 });
    this->DrawLevels(this->Draw(2, 6));
    this->DrawOptions();
  }

  /// Any number of joins forced and forbidden, some of which cannot be.
  void DrawOverrides(const ContourSet& contours)
  {
    for (int i = this->Draw(0, 2) == 0 ? this->Draw(1, 4) : 0; i > 0; --i)
    {
      const int last = static_cast<int>(contours.Contours.size()) - 1;
      auto& joins =
        this->Draw(0, 1) == 0 ? this->Options.ForcedJoins : this->Options.ForbiddenJoins;
      joins.emplace_back(this->Draw(0, last), this->Draw(0, last));
    }
  }

private:
  enum ShapeType
  {
    Star,
    WholeNumberStar, ///< many cocircular points, also from level to level
    Pixels,
    RegularRing ///< all points on circles about common middles
  };

  int Draw(int from, int to) { return std::uniform_int_distribution<int>(from, to)(this->Random); }
  double Between(double from, double to)
  {
    return std::uniform_real_distribution<double>(from, to)(this->Random);
  }
  double OneOf(const std::vector<double>& values)
  {
    return values[this->Draw(0, static_cast<int>(values.size()) - 1)];
  }

  /// About `middle`, between 0.6 of the reach and the reach.
  Ring DrawRing(const Point2& middle, double reach)
  {
    switch (this->Shape)
    {
      case Star:
        return RandomStar(this->Draw(3, 24), middle, 0.6 * reach, reach, this->Random);
      case WholeNumberStar:
      {
        Ring ring = RandomStar(this->Draw(4, 16), middle, 0.6 * reach, reach, this->Random);
        for (Point2& p : ring)
        {
          p = { std::round(16 * p[0]) / 16, std::round(16 * p[1]) / 16 };
        }
        return ring;
      }
      case Pixels:
        return PixelDisc(std::max(1, static_cast<int>(8 * reach)), 0.125, middle);
      case RegularRing:
        break;
    }
    return RegularPolygon(this->Draw(3, 12), reach, FullTurn / 8 * this->Draw(0, 3), middle);
  }

  /// An outline, its hole, an island in that, and so on; some holes touch their outline in a
  /// corner.
  void DrawNest(const Point2& middle, double reach, std::vector<Ring>& rings)
  {
    for (int depth = this->Draw(1, 5); depth > 0; --depth)
    {
      rings.push_back(this->DrawRing(middle, reach));
      if (this->Draw(0, 7) == 0)
      {
        rings.push_back(TouchingHole(rings.back(), middle));
        return;
      }
      reach *= 0.5;
    }
  }

  /// A triangle from a corner of the outline to both sides of its middle.
  static Ring TouchingHole(const Ring& outline, const Point2& middle)
  {
    const Point2& corner = outline.front();
    const Point2 way{ middle[0] - corner[0], middle[1] - corner[1] };
    return { corner,
      { corner[0] + 0.8 * way[0] - 0.2 * way[1], corner[1] + 0.8 * way[1] + 0.2 * way[0] },
      { corner[0] + 0.8 * way[0] + 0.2 * way[1], corner[1] + 0.8 * way[1] - 0.2 * way[0] } };
  }

  Point2 MiddleOf(int place) const
  {
    return { this->Pitch * (place % this->Places), this->Pitch * (place / this->Places) };
  }

  /// Rings of one level by place; an outline around several places is that of place 0.
  std::vector<std::vector<Ring>> DrawLevel(const std::vector<std::vector<Ring>>& previous)
  {
    std::vector<std::vector<Ring>> level(this->Places * this->Places);
    for (std::size_t place = 0; place < level.size(); ++place)
    {
      const Point2 middle = this->MiddleOf(static_cast<int>(place));
      switch (this->Draw(0, 7))
      {
        case 0:
        case 1:
          break; // nothing here
        case 2:
        case 3:
          level[place] = previous.empty() ? level[place] : previous[place];
          break;
        case 4: // two, side by side
          this->DrawNest({ middle[0] - 0.5, middle[1] }, 0.48, level[place]);
          this->DrawNest({ middle[0] + 0.5, middle[1] }, 0.48, level[place]);
          break;
        default:
          this->DrawNest(middle, 1, level[place]);
          break;
      }
    }
    if (this->Draw(0, 5) == 0)
    {
      const double half = 0.5 * this->Pitch * (this->Places - 1);
      level[0].push_back(this->DrawRing({ half, half }, 2.5 + 2 * half));
    }
    if (this->Draw(0, 11) == 0)
    {
      const double reach = this->Pitch * this->Places;
      level[0].push_back(this->DrawRing({ this->Between(0, reach), this->Between(0, reach) }, 1));
    }
    return level;
  }

  void DrawLevels(int count)
  {
    // Planes that no coordinate axis lies in, or the usual ones; where DICOM coordinates are, or
    // not.
    const bool tilted = this->Draw(0, 3) == 0;
    const double angle = tilted ? 0.7 : 0, turn = tilted ? 0.4 : 0;
    const Point3 u{ std::cos(turn), std::sin(turn) * std::cos(angle),
      std::sin(turn) * std::sin(angle) };
    const Point3 v{ -std::sin(turn), std::cos(turn) * std::cos(angle),
      std::cos(turn) * std::sin(angle) };
    const Point3 normal = Cross(u, v);
    const Point3 origin =
      this->Draw(0, 3) == 0 ? Point3{ -250.25, 133.5, 1017.125 } : Point3{ 0, 0, 0 };
    double height = 0;
    std::vector<std::vector<Ring>> level;
    for (int l = 0; l < count; ++l)
    {
      level = this->DrawLevel(level);
      for (const auto& rings : level)
      {
        for (const Ring& ring : rings)
        {
          LoopSoup::Chain chain;
          chain.Closed = true;
          chain.Source = static_cast<int>(this->Soup.Chains.size());
          for (const Point2& p : ring)
          {
            chain.Points.push_back(static_cast<int>(this->Soup.Points.size()));
            this->Soup.Points.push_back(origin + p[0] * u + p[1] * v + height * normal);
          }
          if (this->Draw(0, 1) == 0)
          {
            std::reverse(chain.Points.begin(), chain.Points.end());
          }
          this->Soup.Chains.push_back(chain);
        }
      }
      height += this->OneOf({ 1, 1, 1, 0.5, 2, 6, 0.05 });
    }
  }

  void DrawOptions()
  {
    this->Cleaning.Holes = static_cast<HoleRule>(this->Draw(0, 3));
    PolyhedralOptions& o = this->Options;
    o.InternalPoints = this->Draw(0, 7) != 0;
    o.LiftInternalPoints = this->Draw(0, 7) != 0;
    o.Mapping = static_cast<PolyhedralOptions::MappingType>(this->Draw(0, 1));
    o.OverlapThreshold = this->OneOf({ 0, 0.1, 0.1, 0.5 });
    o.MaximumGap = this->OneOf({ 0, 0, 1.5, 3 });
    o.EndCaps = static_cast<PolyhedralOptions::EndCapsType>(this->Draw(0, 2));
    o.IsolatedContours = static_cast<PolyhedralOptions::IsolatedContoursType>(this->Draw(0, 1));
    o.Threads = this->Draw(1, 2);
  }

  std::mt19937 Random;
  ShapeType Shape = Star;
  int Places = 1;
  double Pitch = 2.1;
};

inline void ExpectSoundNestedStack(unsigned seed)
{
  NestedStack stack(seed);
  SCOPED_TRACE("seed " + std::to_string(seed) + "; again: CONTOUR_STACK_SEED=" +
    std::to_string(seed) + " ctest -R NestedStacks; " + Describe(stack.Options));
  ContourSet contours;
  if (stack.Soup.Chains.empty())
  {
    return;
  }
  Monitor monitor;
  ASSERT_NO_THROW(contours = BuildContourSet(stack.Soup, stack.Cleaning, monitor));
  if (contours.Levels.size() < 2)
  {
    return;
  }
  stack.DrawOverrides(contours);
  PolyhedralSurface surface;
  ASSERT_NO_THROW(surface = BuildSurface(contours, stack.Options));
  ExpectKeepsPromisesOrIsEmpty(surface, contours);
}

inline void ExpectSoundNestedStacks(unsigned first, unsigned last)
{
  if (const char* only = std::getenv("CONTOUR_STACK_SEED"))
  {
    ExpectSoundNestedStack(static_cast<unsigned>(std::atoi(only)));
    return;
  }
  for (unsigned seed = first; seed <= last; ++seed)
  {
    ExpectSoundNestedStack(seed);
  }
}
}

#endif
