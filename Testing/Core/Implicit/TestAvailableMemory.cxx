// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Solver/AvailableMemory.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

using namespace recon;

TEST(AvailableMemory, IsSomeAndNotMoreThanTheMachineHas)
{
  const double available = AvailableGigabytes();
  EXPECT_GT(available, 0);
  std::ifstream file("/proc/meminfo");
  std::string word;
  double total = 0;
  while (file >> word)
  {
    if (word == "MemTotal:" && file >> total)
    {
      break;
    }
  }
  if (total == 0)
  {
    GTEST_SKIP() << "this system does not tell its memory";
  }
  EXPECT_LE(available, total * 1024 / 1e9);
}
