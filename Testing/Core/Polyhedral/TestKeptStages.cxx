// SPDX-License-Identifier: GPL-3.0-or-later
// Contours that change one at a time: what is kept of the last run must not show.
#include "Core/Contours/SoupMaker.h"
#include "Polyhedral/KeptStages.h"
#include "Polyhedral/PolyhedralSurface.h"
#include "PolyhedralShapes.h"
#include "SameSurface.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

using namespace recon;
using namespace recon::testing;

namespace
{
/// Stars that wander, grow, part and end from level to level, and one gap.
class EditedStack
{
public:
  EditedStack(unsigned seed, int levels) : Random(seed)
  {
    for (int l = 0; l < levels; ++l)
    {
      this->Levels.emplace_back();
      const int count = this->Draw(1, 3);
      for (int i = 0; i < count; ++i)
      {
        this->AddRing(l);
      }
    }
  }

  /// One ring of one level comes, goes, gets a point or loses its place.
  void Edit()
  {
    const int level = this->Draw(0, static_cast<int>(this->Levels.size()) - 1);
    std::vector<Ring>& rings = this->Levels[level];
    Ring& ring = rings[this->Draw(0, static_cast<int>(rings.size()) - 1)];
    switch (this->Draw(0, 4))
    {
      case 0:
        this->AddRing(level);
        break;
      case 1:
        if (rings.size() > 1)
        {
          rings.pop_back();
        }
        break;
      case 2:
        ring.insert(
          ring.begin() + 1, { 0.5 * (ring[0][0] + ring[1][0]), 0.5 * (ring[0][1] + ring[1][1]) });
        break;
      default:
        ring[0] = { ring[0][0] + 0.01 * this->Draw(1, 9), ring[0][1] };
    }
  }

  ContourSet Build() const
  {
    SoupMaker maker;
    for (std::size_t l = 0; l < this->Levels.size(); ++l)
    {
      const double gap = 2 * l > this->Levels.size() ? 9 : 0;
      for (const Ring& ring : this->Levels[l])
      {
        maker.Loop(ring, static_cast<double>(l) + gap);
      }
    }
    return maker.Build();
  }

private:
  int Draw(int from, int to) { return std::uniform_int_distribution<int>(from, to)(this->Random); }

  void AddRing(int level)
  {
    const Point2 middle{ 0.5 * this->Draw(-6, 6), 0.5 * this->Draw(-6, 6) };
    this->Levels[level].push_back(
      Circle(middle[0], middle[1], 0.25 * this->Draw(2, 14), this->Draw(5, 16)));
  }

  std::mt19937 Random;
  std::vector<std::vector<Ring>> Levels;
};

PolyhedralOptions OptionsOf(unsigned seed)
{
  PolyhedralOptions options;
  options.Mapping = seed % 4 == 3 ? PolyhedralOptions::Proximity : PolyhedralOptions::Overlap;
  options.EndCaps = static_cast<PolyhedralOptions::EndCapsType>(seed % 5);
  options.IsolatedContours = seed % 2 == 0 ? PolyhedralOptions::Extrude : PolyhedralOptions::Drop;
  options.InternalPoints = seed % 7 != 6;
  options.AlignLevels = static_cast<LevelAlignmentMode>(seed % 3);
  options.Threads = 1 + static_cast<int>(seed % 2);
  return options;
}

/// Returns how many levels were made, of the edits that were not the first.
std::size_t ExpectSameAfterEdits(unsigned seed, int levels, int edits, TetrahedraWanted wanted)
{
  SCOPED_TRACE("seed " + std::to_string(seed));
  EditedStack stack(seed, levels);
  const PolyhedralOptions options = OptionsOf(seed);
  KeptStages kept;
  Monitor monitor;
  std::size_t made = 0;
  for (int edit = 0; edit <= edits; ++edit)
  {
    SCOPED_TRACE("edit " + std::to_string(edit));
    const ContourSet contours = stack.Build();
    ExpectSameSurface(BuildPolyhedralSurface(contours, options, monitor, wanted, &kept),
      BuildPolyhedralSurface(contours, options, monitor, wanted));
    made += edit > 0 ? kept.LevelsMade() : 0;
    stack.Edit();
  }
  return made;
}
}

TEST(KeptStages, GiveTheSameSurface)
{
  for (unsigned seed = 1; seed <= 15; ++seed)
  {
    ExpectSameAfterEdits(seed, 50, 5, TetrahedraWanted::ForSurface);
  }
}

TEST(KeptStages, GiveTheSameSurfaceOfDenseContours)
{
  for (unsigned seed = 21; seed <= 24; ++seed)
  {
    ExpectSameAfterEdits(seed, 40, 4, TetrahedraWanted::BoundaryOnly);
  }
}

TEST(KeptStages, MakeOnlyWhatAChangeReaches)
{
  constexpr int levels = 100;
  constexpr int edits = 8;
  // Of round ends the most rounds are needed: seven levels on either side, and as many again.
  const std::size_t made = ExpectSameAfterEdits(12, levels, edits, TetrahedraWanted::ForSurface);
  EXPECT_GT(made, 0u);
  EXPECT_LE(made, edits * 30u);
}

TEST(KeptStages, MakeNothingWhereNothingChanged)
{
  const ContourSet contours = EditedStack(5, 30).Build();
  KeptStages kept;
  Monitor monitor;
  PolyhedralOptions options = OptionsOf(12);
  const PolyhedralSurface first =
    BuildPolyhedralSurface(contours, options, monitor, TetrahedraWanted::ForSurface, &kept);
  EXPECT_EQ(kept.LevelsMade(), contours.Levels.size());
  ExpectSameSurface(
    BuildPolyhedralSurface(contours, options, monitor, TetrahedraWanted::ForSurface, &kept), first);
  EXPECT_EQ(kept.LevelsMade(), 0u);
  options.IsolatedContours = PolyhedralOptions::Drop;
  BuildPolyhedralSurface(contours, options, monitor, TetrahedraWanted::ForSurface, &kept);
  EXPECT_EQ(kept.LevelsMade(), contours.Levels.size());
}
