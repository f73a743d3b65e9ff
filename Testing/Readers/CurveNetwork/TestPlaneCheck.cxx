// SPDX-License-Identifier: GPL-3.0-or-later
#include "CurveNetwork/PlaneCheck.h"

#include <gtest/gtest.h>

TEST(PlaneCheck, TellsSignOffsetAndNormalApart)
{
  const std::vector<recon::Point3> vertices{ { 0, 0, 5 }, { 9, 0, 5 }, { 0, 9, 5 } };
  EXPECT_EQ(recon::CheckPlane({ 0, 0, 3 }, -15, vertices), recon::PlaneFit::Fits);
  EXPECT_EQ(recon::CheckPlane({ 0, 0, 3 }, 15, vertices), recon::PlaneFit::WrongSign);
  EXPECT_EQ(recon::CheckPlane({ 0, 0, 3 }, 14, vertices), recon::PlaneFit::WrongOffset);
  EXPECT_EQ(recon::CheckPlane({ 0, 1, 3 }, -15, vertices), recon::PlaneFit::WrongNormal);
  EXPECT_EQ(recon::CheckPlane({ 0, 0, 0 }, 0, vertices), recon::PlaneFit::WrongNormal);
  EXPECT_EQ(recon::NormalOf(vertices, { 0, 1, -3 }), (recon::Vector3{ 0, 0, -1 }));
}

TEST(PlaneCheck, FitsWithinAThousandthOfTheExtent)
{
  const std::vector<recon::Point3> vertices{ { 0, 0, 5 }, { 900, 0, 5 }, { 0, 900, 5.5 } };
  EXPECT_EQ(recon::CheckPlane({ 0, 0, 1 }, -5, vertices), recon::PlaneFit::Fits);
  EXPECT_EQ(recon::CheckPlane({ 0, 0, 1 }, -3, vertices), recon::PlaneFit::WrongOffset);
}

TEST(PlaneCheck, NormalOfALineIsTheAxis)
{
  const std::vector<recon::Point3> line{ { 0, 0, 0 }, { 1, 2, 3 }, { 2, 4, 6 } };
  EXPECT_EQ(recon::NormalOf(line, { 1, 0, 0 }), (recon::Vector3{ 0, 0, 1 }));
}
