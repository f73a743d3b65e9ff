// SPDX-License-Identifier: GPL-3.0-or-later
// What is written comes back by the parser, to the last bit.
#include "Readers/ReaderTesting.h"

#include "Table/ContourTableFormatter.h"
#include "Table/ContourTableParser.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace readertesting;

namespace
{
class ContourTableFormatter : public Folder
{
protected:
  recon::TracedFile Back(const recon::TracedFile& file)
  {
    this->FileName = this->Write("table.csv", "");
    this->Report = recon::WriteContourTable(this->FileName, file, this->Monitor);
    EXPECT_TRUE(recon::IsContourTable(this->FileName));
    return recon::ReadContourTable(this->FileName, { 1, 1 }, this->Monitor);
  }
  std::string FileName;
  std::vector<std::string> Report;
  recon::Monitor Monitor;
};

void AddLoop(recon::TracedObject& object, const std::vector<recon::Point3>& points, int slice)
{
  recon::LoopSoup::Chain chain;
  chain.Closed = true;
  for (const recon::Point3& point : points)
  {
    chain.Points.push_back(static_cast<int>(object.Soup.Points.size()));
    object.Soup.Points.push_back(point);
  }
  object.Soup.Chains.push_back(chain);
  object.Slices.push_back(slice);
}

std::vector<recon::Point3> PointsOf(const recon::TracedObject& object, std::size_t chain)
{
  std::vector<recon::Point3> points;
  for (const int p : object.Soup.Chains[chain].Points)
  {
    points.push_back(object.Soup.Points[p]);
  }
  return points;
}

/// Turned so that the smallest point is the first: one loop wherever it begins.
std::vector<recon::Point3> FromSmallest(std::vector<recon::Point3> points)
{
  std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
  return points;
}

const std::vector<recon::Point3> Triangle{ { 0.1, 1e-300, 7 }, { 1.0 / 3, -2.5, 7 },
  { 4, 5e17, 7 } };
/// Upright, with four points at each of two z: as good as two contours.
const std::vector<recon::Point3> Upright{ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 },
  { 3, 0, 1 }, { 2, 0, 1 }, { 1, 0, 1 }, { 0, 0, 1 } };
}

TEST_F(ContourTableFormatter, WhatIsWrittenComesBackToTheLastBit)
{
  recon::TracedFile file;
  file.LengthUnit = "mm";
  file.Objects.resize(2);
  file.Objects[0].Name = "Lt; Lung, 100% \"upper\"";
  AddLoop(file.Objects[0], Triangle, 12);
  AddLoop(file.Objects[0], Triangle, 12); // the same once more is a contour of its own
  file.Objects[1].Name = "#2";
  AddLoop(file.Objects[1], Upright, -3);
  const recon::TracedFile back = this->Back(file);
  ASSERT_EQ(back.Objects.size(), 2u);
  EXPECT_EQ(back.LengthUnit, "mm");
  EXPECT_EQ(back.Objects[0].Name, "Lt; Lung, 100% 'upper'");
  EXPECT_EQ(this->Report.size(), 1u); // that name
  EXPECT_EQ(back.Objects[1].Name, "#2");
  ASSERT_EQ(back.Objects[0].Soup.Chains.size(), 2u);
  EXPECT_EQ(PointsOf(back.Objects[0], 0), Triangle);
  EXPECT_EQ(PointsOf(back.Objects[0], 1), Triangle);
  EXPECT_EQ(back.Objects[0].Slices, (std::vector<int>{ 12, 12 }));
  ASSERT_EQ(back.Objects[1].Soup.Chains.size(), 1u);
  EXPECT_EQ(FromSmallest(PointsOf(back.Objects[1], 0)), FromSmallest(Upright));
}

TEST_F(ContourTableFormatter, ObjectsOfOneNameStayApart)
{
  recon::TracedFile file;
  file.Objects.resize(2);
  for (recon::TracedObject& object : file.Objects)
  {
    object.Name = "Node";
    AddLoop(object, Triangle, 0);
  }
  const recon::TracedFile back = this->Back(file);
  ASSERT_EQ(back.Objects.size(), 2u);
  EXPECT_EQ(back.Objects[1].Name, "Node (2)");
}

TEST_F(ContourTableFormatter, LeavesOutWhatIsNotClosedAndSaysSo)
{
  recon::TracedFile file;
  file.Objects.resize(1);
  AddLoop(file.Objects[0], Triangle, 0);
  AddLoop(file.Objects[0], { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 3, 0 } }, 0);
  file.Objects[0].Soup.Chains[1].Closed = false;
  AddLoop(file.Objects[0], { { 5, 5, 5 } }, 0);
  EXPECT_EQ(this->Back(file).Objects[0].Soup.Chains.size(), 1u);
  ASSERT_FALSE(this->Report.empty());
  EXPECT_EQ(this->Report.back().find("2 open line"), 0u) << this->Report.back();
  file.Objects[0].Soup.Chains.erase(file.Objects[0].Soup.Chains.begin());
  EXPECT_THROW(this->Back(file), recon::Error);
}

TEST_F(ContourTableFormatter, NoFileOfWhatIsNoNumber)
{
  recon::TracedFile file;
  file.Objects.resize(1);
  AddLoop(file.Objects[0], Triangle, 0);
  file.Objects[0].Soup.Points[1][2] = std::numeric_limits<double>::quiet_NaN();
  const std::string there = this->Write("table.csv", "what was there");
  EXPECT_THROW(recon::WriteContourTable(there, file, this->Monitor), recon::Error);
  EXPECT_EQ(Bytes(there), "what was there");
}

TEST_F(ContourTableFormatter, TheFirstPointIsNotRepeatedHoweverOftenItWas)
{
  recon::TracedFile file;
  file.Objects.emplace_back();
  file.Objects[0].Name = "a";
  AddLoop(file.Objects[0], { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 0, 0 }, { 0, 0, 0 } }, 0);
  EXPECT_EQ(PointsOf(this->Back(file).Objects.at(0), 0).size(), 3u);
}
