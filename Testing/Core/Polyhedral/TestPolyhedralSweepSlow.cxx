// SPDX-License-Identifier: GPL-3.0-or-later
// Every option and several threads on the large contour sets, which takes minutes.
#include "PolyhedralSweep.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

namespace
{
const Case LargeCases[] = {
  { "rtstruct/cerr_ibsi.dcm", 1 },
  { "rtstruct/dicompyler_rtss.dcm", 9 },
  { "rtstruct/dicomexport_rs.dcm", 11 },
  { "rtstruct/pyorthanc_cone_02mm.dcm", 1 },
  { "cnt/amygdala_label3.cnt", 1 },
  { "cnt/sainthelens_100m.cnt", 1 },
  { "cnt/sainthelens_unequal.cnt", 1 },
};
}

TEST_P(PolyhedralSweep, HoldsForEveryOption)
{
  EXPECT_EQ(ForEachSolid(this->Path, ExpectAllOptions), GetParam().Solids);
}

INSTANTIATE_TEST_SUITE_P(Large, PolyhedralSweep, ::testing::ValuesIn(LargeCases), NameOf);

TEST(PolyhedralOwnData, HoldsForEveryOption)
{
  EXPECT_EQ(ForEachSolid(OwnPath("Data/head.cnt"), ExpectAllOptions), 1);
}
