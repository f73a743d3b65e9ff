// SPDX-License-Identifier: GPL-3.0-or-later
#include "RandomStacks.h"

TEST(PolyhedralStacks, HundredRandomStacks)
{
  recon::testing::ExpectSoundStacks(1, 100);
}
