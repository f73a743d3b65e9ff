// SPDX-License-Identifier: GPL-3.0-or-later
#include "DegenerateStacks.h"

#include <gtest/gtest.h>

using namespace recon::testing;

TEST(DegenerateStacks, TwentyThousandStacks)
{
  ExpectSoundDegenerateStacks(1001, 21000);
}

TEST(DegenerateStacks, FiveThousandTiltedStacks)
{
  ExpectSoundDegenerateStacks(1001, 6000, StackFrame::Tilted);
}

// Needles a little wider than what is snapped together took more points than a level may have.
TEST(DegenerateStacks, NeedlesBesideNeedles)
{
  ExpectSoundDegenerateStack(1433);
}
