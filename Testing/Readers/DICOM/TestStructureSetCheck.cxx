// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/StructureSetCheck.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{
recon::WrittenROI WithType(const std::string& type, double bent = 0)
{
  recon::WrittenROI roi;
  roi.Description.Name = "A";
  roi.Contours.push_back(
    { { { 0, 0, 0 }, { 9, 0, 0 }, { 9, 9, bent }, { 0, 9, 0 } }, type, "cell 0" });
  return roi;
}

std::vector<std::string> Check(recon::WrittenROI& roi, bool exclusiveOr = false)
{
  std::vector<std::string> report;
  recon::CheckContours(roi, exclusiveOr, report);
  return report;
}
}

TEST(StructureSetCheck, GoodContoursPass)
{
  for (const char* type : { "CLOSED_PLANAR", "OPEN_PLANAR", "OPEN_NONPLANAR" })
  {
    recon::WrittenROI roi = WithType(type);
    EXPECT_TRUE(Check(roi).empty()) << type;
    EXPECT_EQ(roi.Contours[0].GeometricType, type);
  }
}

TEST(StructureSetCheck, PlanesAreThoseOfTheTypes)
{
  recon::WrittenROI closed = WithType("CLOSED_PLANAR", 5);
  EXPECT_THROW(Check(closed), recon::Error);
  recon::WrittenROI rounded = WithType("CLOSED_PLANAR", 0.01);
  EXPECT_TRUE(Check(rounded).empty());
  recon::WrittenROI open = WithType("OPEN_PLANAR", 5);
  EXPECT_EQ(Check(open).size(), 1u);
  EXPECT_EQ(open.Contours[0].GeometricType, "OPEN_NONPLANAR");
}

TEST(StructureSetCheck, CoordinatesAreNumbersOfAPatient)
{
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(), 1e9 })
  {
    recon::WrittenROI roi = WithType("POINT");
    roi.Contours[0].Points[0][1] = bad;
    EXPECT_THROW(Check(roi), recon::Error);
  }
}

TEST(StructureSetCheck, TooFewPointsAreLeftOut)
{
  recon::WrittenROI roi = WithType("CLOSED_PLANAR");
  roi.Contours[0].Points.resize(2);
  const std::vector<std::string> report = Check(roi);
  EXPECT_TRUE(roi.Contours.empty());
  ASSERT_EQ(report.size(), 2u);
  EXPECT_EQ(report[1], "ROI \"A\": left out, it has no contours.");
}

TEST(StructureSetCheck, OneExclusiveOrMakesAllOfTheROISo)
{
  recon::WrittenROI roi = WithType("CLOSED_PLANAR");
  roi.Contours.push_back(WithType("CLOSEDPLANAR_XOR").Contours[0]);
  roi.Contours.push_back(WithType("OPEN_PLANAR").Contours[0]);
  Check(roi);
  EXPECT_EQ(roi.Contours[0].GeometricType, "CLOSEDPLANAR_XOR");
  EXPECT_EQ(roi.Contours[2].GeometricType, "OPEN_PLANAR");
  recon::WrittenROI asked = WithType("CLOSED_PLANAR");
  Check(asked, true);
  EXPECT_EQ(asked.Contours[0].GeometricType, "CLOSEDPLANAR_XOR");
}
