// SPDX-License-Identifier: GPL-3.0-or-later
// Twenty thousand stacks upright and as many tilted, in pieces of a thousand: `ctest -j` runs as many of
// them beside each other as there are processors.
#include "DegenerateStacks.h"

#include <gtest/gtest.h>

using namespace recon::testing;

namespace
{
constexpr int APiece = 1000;

/// The parameter is the first seed of a piece.
class ThousandStacks : public ::testing::TestWithParam<int>
{
protected:
  static void ExpectSound(StackFrame frame)
  {
    const auto first = static_cast<unsigned>(GetParam());
    ExpectSoundDegenerateStacks(first, first + APiece - 1, frame);
  }
};
}

TEST_P(ThousandStacks, Upright)
{
  ExpectSound(StackFrame::Upright);
}

TEST_P(ThousandStacks, Tilted)
{
  ExpectSound(StackFrame::Tilted);
}

INSTANTIATE_TEST_SUITE_P(DegenerateStacks, ThousandStacks, ::testing::Range(1001, 21001, APiece));

// Needles a little wider than what is snapped together took more points than a level may have.
TEST(DegenerateStacks, NeedlesBesideNeedles)
{
  ExpectSoundDegenerateStack(1433);
}

// Rows of tetrahedra that lose their hold one after the other took a look at all of them each.
TEST(DegenerateStacks, RowsThatComeLooseOneByOne)
{
  ExpectSoundDegenerateStack(6981);
}
