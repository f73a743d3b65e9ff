// SPDX-License-Identifier: GPL-3.0-or-later
#include "RandomStacks.h"

TEST(PolyhedralStacks, ThousandRandomStacks)
{
  recon::testing::ExpectSoundStacks(101, 1100);
}
