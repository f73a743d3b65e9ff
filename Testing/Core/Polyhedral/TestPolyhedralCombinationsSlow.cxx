// SPDX-License-Identifier: GPL-3.0-or-later
// Every combination of Mapping, EndCaps (but None, which is open) and IsolatedContours on every
// contour set at hand: each surface is sound and gives its contours back.
#include "PolyhedralSweep.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

namespace
{
class PolyhedralCombinations : public PolyhedralSweep
{
};
}

TEST_P(PolyhedralCombinations, KeepPromises)
{
  EXPECT_EQ(ForEachSolid(this->Path, ExpectAllCombinations), GetParam().Solids);
}

INSTANTIATE_TEST_SUITE_P(Data, PolyhedralCombinations, ::testing::ValuesIn(AllCases), NameOf);
INSTANTIATE_TEST_SUITE_P(
  Networks, PolyhedralCombinations, ::testing::ValuesIn(NetworkCases), NameOf);

TEST(PolyhedralOwnData, EveryCombination)
{
  for (const char* name : { "branching_pipe.cnt", "brain.cnt", "head.cnt", "femur_head.csl" })
  {
    SCOPED_TRACE(name);
    EXPECT_EQ(ForEachSolid(OwnPath(std::string("Data/") + name), ExpectAllCombinations), 1);
  }
}
