// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/ReferenceSlices.h"

#include <gtest/gtest.h>

#include <cmath>

using recon::ReferenceSlice;
using recon::ReferenceSlices;

namespace
{
ReferenceSlice SliceAt(double offset, const recon::Vector3& normal = { 0, 0, 1 })
{
  ReferenceSlice slice;
  slice.InstanceUID = std::to_string(static_cast<int>(std::lround(offset)));
  slice.Normal = normal;
  slice.Offset = offset;
  return slice;
}

std::vector<recon::Point3> ContourAt(double z, double other)
{
  return { { 0, 0, z }, { 5, 0, other }, { 5, 5, z } };
}

/// The slice of a contour; empty for none.
std::string Found(const ReferenceSlices& slices, double z, double other)
{
  const ReferenceSlice* slice = slices.Find(ContourAt(z, other));
  return slice ? slice->InstanceUID : "";
}
}

TEST(ReferenceSlices, AContourIsOnTheSliceThatAllItsPointsAreNear)
{
  const ReferenceSlices slices({ SliceAt(0), SliceAt(3), SliceAt(6), SliceAt(9) }, 4);
  EXPECT_DOUBLE_EQ(slices.GetTolerance(), 1.5);
  EXPECT_EQ(slices.GetSlices().size(), 4u);
  EXPECT_EQ(Found(slices, 3, 3), "3");
  EXPECT_EQ(Found(slices, 4.4, 4.4), "3");
  EXPECT_EQ(Found(slices, 4.6, 4.6), "6");
  EXPECT_EQ(Found(slices, 10.4, 10.4), "9");
  EXPECT_EQ(Found(slices, 10.6, 10.6), "");
  EXPECT_EQ(Found(slices, 3, 6), ""); // across two
}

TEST(ReferenceSlices, WhereOthersMayLieBetweenAContourMustBeInThePlane)
{
  const ReferenceSlices slices({ SliceAt(0), SliceAt(9), SliceAt(18) }, 7);
  EXPECT_DOUBLE_EQ(slices.GetTolerance(), 0.1);
  EXPECT_EQ(Found(slices, 9.05, 9.05), "9");
  EXPECT_EQ(Found(slices, 9.2, 9.2), "");
}

TEST(ReferenceSlices, OneSliceOrNone)
{
  EXPECT_EQ(Found(ReferenceSlices({ SliceAt(3) }, 1), 3.05, 3.05), "3");
  EXPECT_EQ(Found(ReferenceSlices({ SliceAt(3) }, 1), 3.2, 3.2), "");
  EXPECT_EQ(Found(ReferenceSlices(), 3, 3), "");
}

TEST(ReferenceSlices, SpacingIsThatOfTheMostFrequentDirection)
{
  const ReferenceSlices slices(
    { SliceAt(0), SliceAt(3), SliceAt(6), SliceAt(50, { 1, 0, 0 }), SliceAt(51, { 1, 0, 0 }) }, 5);
  EXPECT_DOUBLE_EQ(slices.GetTolerance(), 1.5);
}

TEST(ReferenceSlices, ImagesInOnePlaneAreNotBetween)
{
  const ReferenceSlices slices(
    { SliceAt(0), SliceAt(3), SliceAt(6), SliceAt(0), SliceAt(3), SliceAt(6) }, 6);
  EXPECT_DOUBLE_EQ(slices.GetTolerance(), 1.5);
}

TEST(SliceNormal, IsOfLengthOneAndAnAxisButForRounding)
{
  EXPECT_EQ(recon::SliceNormal({ 0, 0, -7 }), (recon::Vector3{ 0, 0, 1 }));
  EXPECT_EQ(recon::SliceNormal({ 1e-6, 0, 1 }), (recon::Vector3{ 0, 0, 1 }));
  EXPECT_EQ(recon::SliceNormal({ 0, 0, 0 }), (recon::Vector3{ 0, 0, 0 }));
  const recon::Vector3 tilted = recon::SliceNormal({ 0, -3, 4 });
  EXPECT_NEAR(tilted[1], -0.6, 1e-15);
  EXPECT_NEAR(tilted[2], 0.8, 1e-15);
}
