// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/StaircaseStep.h"

#include "Core/Polyhedral/PolyhedralShapes.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

TEST(StaircaseStep, OfADiscOfPixels)
{
  for (const double pixel : { 1.0, 0.7 })
  {
    const Ring disc = PixelDisc(12, pixel);
    EXPECT_NEAR(StaircaseStep(BuildStack({ { disc }, { disc } })), pixel, 1e-9);
  }
}

TEST(StaircaseStep, NoneOfWhatIsDrawn)
{
  EXPECT_EQ(StaircaseStep(BuildStack({ { RegularPolygon(40, 3) }, { RegularPolygon(7, 3) } })), 0);
  EXPECT_EQ(StaircaseStep(BuildStack({ { Rectangle(0, 0, 4, 2) }, { Rectangle(0, 0, 4, 2) } })), 0);
}
