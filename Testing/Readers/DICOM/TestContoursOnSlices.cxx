// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/ContourSetBuilder.h"
#include "DICOM/ContoursOnSlices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace recon;

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double Radius = 20;

/// Circles of a ball about the origin.
ContourSet Ball(const std::vector<double>& heights)
{
  LoopSoup soup;
  soup.Millimetres = true;
  for (const double z : heights)
  {
    LoopSoup::Chain chain;
    chain.Closed = true;
    const double r = std::sqrt(Radius * Radius - z * z);
    for (int i = 0; i < 48; ++i)
    {
      chain.Points.push_back(static_cast<int>(soup.Points.size()));
      soup.Points.push_back({ r * std::cos(i * Pi / 24), r * std::sin(i * Pi / 24), z });
    }
    soup.Chains.push_back(chain);
  }
  Monitor monitor;
  return BuildContourSet(soup, ContourSetOptions(), monitor);
}

SlicesOfReference Slices(double first, double last, double spacing)
{
  SlicesOfReference slices;
  slices.Tolerance = spacing / 2;
  for (double z = first; z <= last; z += spacing)
  {
    ReferenceSlice slice;
    slice.Offset = z;
    slice.PixelArea = 1;
    slices.Slices.push_back(slice);
  }
  return slices;
}

ContourSet OnSlices(const ContourSet& drawn, const SlicesOfReference& slices,
  SliceContourOptions::MethodType method, bool extrapolate = false)
{
  SliceContourOptions options;
  options.Method = method;
  options.Extrapolate = extrapolate;
  Monitor monitor;
  return ContoursOnSlices(drawn, slices, options, monitor);
}

double AreaAt(double z)
{
  return Pi * (Radius * Radius - z * z);
}

bool Says(const ContourSet& contours, const std::string& part)
{
  for (const std::string& line : contours.Report)
  {
    if (line.find(part) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}
}

TEST(ContoursOnSlices, ABallComesBackBetweenWhatWasDrawn)
{
  const ContourSet drawn = Ball({ -12, -6, 0, 6, 12 });
  for (const auto method : { SliceContourOptions::Implicit, SliceContourOptions::Polyhedral })
  {
    const ContourSet contours = OnSlices(drawn, Slices(-30, 30, 3), method);
    ASSERT_EQ(contours.Levels.size(), 9u);
    EXPECT_EQ(contours.Levels.front().Offset, -12);
    EXPECT_EQ(contours.Levels.back().Offset, 12);
    EXPECT_TRUE(Says(contours, "9 slices of 21 lie where something was drawn"));
    for (const Level& level : contours.Levels)
    {
      ASSERT_EQ(level.Contours.size(), 1u);
      const double area = contours.Contours[level.Contours.front()].SignedArea;
      EXPECT_NEAR(area, AreaAt(level.Offset), 0.06 * AreaAt(level.Offset)) << level.Offset;
    }
  }
}

TEST(ContoursOnSlices, PolyhedralKeepsWhatWasDrawn)
{
  const ContourSet drawn = Ball({ -12, -6, 0, 6, 12 });
  const ContourSet contours = OnSlices(drawn, Slices(-12, 12, 3), SliceContourOptions::Polyhedral);
  for (const Level& level : drawn.Levels)
  {
    const auto same = std::find_if(contours.Levels.begin(), contours.Levels.end(),
      [&](const Level& l) { return l.Offset == level.Offset; });
    ASSERT_NE(same, contours.Levels.end());
    EXPECT_EQ(contours.Contours[same->Contours.front()].Points.size(), 48u);
    EXPECT_EQ(contours.Contours[same->Contours.front()].SignedArea,
      drawn.Contours[level.Contours.front()].SignedArea);
  }
}

TEST(ContoursOnSlices, ASliceBesideTheLastContourTakesIt)
{
  const ContourSet drawn = Ball({ -12, -6, 0, 6, 12 });
  const ContourSet contours = OnSlices(drawn, Slices(-13, 14, 3), SliceContourOptions::Polyhedral);
  EXPECT_EQ(contours.Levels.front().Offset, -13);
  EXPECT_NEAR(contours.Contours[contours.Levels.front().Contours.front()].SignedArea,
    drawn.Contours.front().SignedArea, 1e-9);
}

TEST(ContoursOnSlices, ExtrapolateGoesOnWhereTheSurfaceCloses)
{
  const ContourSet drawn = Ball({ -12, -6, 0, 6, 12 });
  const ContourSet contours =
    OnSlices(drawn, Slices(-30, 30, 3), SliceContourOptions::Implicit, true);
  EXPECT_GT(contours.Levels.size(), 9u);
  EXPECT_FALSE(Says(contours, "the others are left out"));
}

TEST(ContoursOnSlices, SlicesOfSomebodyElseAreRefused)
{
  for (const auto method : { SliceContourOptions::Implicit, SliceContourOptions::Polyhedral })
  {
    EXPECT_THROW(OnSlices(Ball({ -6, 0, 6 }), Slices(100, 120, 3), method), Error);
  }
}
