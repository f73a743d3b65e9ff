// SPDX-License-Identifier: GPL-3.0-or-later
#include "NestedStacks.h"
#include "RandomStacks.h"

TEST(PolyhedralStacks, ThousandRandomStacks)
{
  recon::testing::ExpectSoundStacks(101, 1100);
}

TEST(PolyhedralNestedStacks, ThousandNestedStacks)
{
  recon::testing::ExpectSoundNestedStacks(1, 1000);
}
