// SPDX-License-Identifier: GPL-3.0-or-later
#include "DegenerateStacks.h"

#include <gtest/gtest.h>

using namespace recon::testing;

TEST(DegenerateStacks, AFewUpright)
{
  ExpectSoundDegenerateStacks(1, 40);
}

TEST(DegenerateStacks, AFewTilted)
{
  ExpectSoundDegenerateStacks(1, 40, StackFrame::Tilted);
}

// Points that were computed for it are rounded in upright planes, too.
TEST(DegenerateStacks, UprightSheetsThatRoundingCrosses)
{
  ExpectSoundDegenerateStack(700031);
}

// Rounded to the coordinates of space, a piece of this came out inside out.
TEST(DegenerateStacks, TiltedPieceAsThinAsRounding)
{
  ExpectSoundDegenerateStack(300735, StackFrame::Tilted);
}

// Rounded to the coordinates of space, sheets of these passed through one another.
TEST(DegenerateStacks, TiltedSheetsThatTouch)
{
  for (const unsigned seed : { 203304u, 205920u, 206578u, 206844u })
  {
    ExpectSoundDegenerateStack(seed, StackFrame::Tilted);
  }
}
