// SPDX-License-Identifier: GPL-3.0-or-later
// A stage follows another as far as every one of its items has what it needs, tried one by one.
#include "Polyhedral/StageFront.h"

#include <gtest/gtest.h>

using namespace recon;

TEST(StageFront, AllowsWhatHasAllThatItNeeds)
{
  for (std::size_t before = 1; before <= 6; ++before)
  {
    for (std::size_t done = 0; done <= before; ++done)
    {
      // Of slabs there is one less than of levels, or one more if it is the other way round.
      for (const std::size_t count : { before - 1, before, before + 1 })
      {
        for (std::size_t ahead = 0; ahead <= 3; ++ahead)
        {
          std::size_t allowed = 0;
          while (allowed < count && std::min(allowed + ahead, before - 1) < done)
          {
            ++allowed;
          }
          EXPECT_EQ((StageFront{ before, done }.Allows(count, ahead)), allowed)
            << done << " of " << before << ", " << count << " with " << ahead;
        }
      }
    }
  }
}
