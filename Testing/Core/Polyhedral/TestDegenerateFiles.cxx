// SPDX-License-Identifier: GPL-3.0-or-later
// Small files that crashed, hung, or broke a promise: every combination of options, each within a
// second.
#include "Core/SetsOfData.h"
#include "DegenerateStacks.h"
#include "TestPaths.h"

#include <gtest/gtest.h>

#include <string>

using namespace recon;
using namespace recon::testing;

namespace
{
class DegenerateFiles
  : public SharedData
  , public ::testing::WithParamInterface<const char*>
{
};
}

TEST_P(DegenerateFiles, HoldEveryPromise)
{
  const std::string path = SharedPath(std::string("faults/other/") + GetParam());
  if (!std::filesystem::exists(path))
  {
    GTEST_SKIP() << path << " is not there";
  }
  SoupMaker maker;
  maker.Soup = ReadSoups(path).front().second;
  EXPECT_EQ(BrokenPromisesOfStack(maker), "");
}

INSTANTIATE_TEST_SUITE_P(Faults, DegenerateFiles,
  ::testing::Values("sliver_crash.cnt", "sliver_hang.cnt", "joint_wrong_cell.cnt", "overlap1.cnt",
    "collinear_1024.cnt", "collinear_1048.cnt", "collinear_1180.cnt", "not_outward.cnt"));
