// SPDX-License-Identifier: GPL-3.0-or-later
#include "NestedStacks.h"
#include "RandomStacks.h"

TEST(PolyhedralStacks, HundredRandomStacks)
{
  recon::testing::ExpectSoundStacks(1, 100);
}

TEST(PolyhedralNestedStacks, HundredNestedStacks)
{
  recon::testing::ExpectSoundNestedStacks(1, 100);
}
