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
