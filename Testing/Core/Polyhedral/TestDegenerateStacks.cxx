// SPDX-License-Identifier: GPL-3.0-or-later
#include "DegenerateStacks.h"

#include <gtest/gtest.h>

using namespace recon::testing;

TEST(DegenerateStacks, FortyStacks)
{
  ExpectSoundDegenerateStacks(1, 40);
}
