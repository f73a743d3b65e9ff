// SPDX-License-Identifier: GPL-3.0-or-later
#include "Readers/ReaderTesting.h"

#include "NUAGES/NUAGESFormatter.h"
#include "NUAGES/NUAGESParser.h"

#include <cmath>
#include <limits>

using namespace readertesting;

namespace
{
class NUAGESFormatter : public Folder
{
protected:
  recon::ContourFile Read(const std::string& fileName)
  {
    return recon::ReadNUAGES(fileName, this->Monitor);
  }
  std::vector<std::string> Write(const std::string& name, const recon::LoopSoup& soup)
  {
    return recon::WriteNUAGES(this->Name(name), soup, this->Monitor);
  }
  std::string WriteSentence(const recon::LoopSoup& soup)
  {
    return SentenceOf([&] { recon::WriteNUAGES(this->Name("out.cnt"), soup, this->Monitor); });
  }
  recon::Monitor Monitor;
};

recon::LoopSoup SquareAt(double z)
{
  recon::LoopSoup soup;
  soup.Points = { { 0, 0, z }, { 1, 0, z }, { 1, 1, z }, { 0, 1, z } };
  soup.Chains.push_back({ { 0, 1, 2, 3 }, true, 0 });
  return soup;
}
}

TEST_F(NUAGESFormatter, RoundTripIsExactToTheLastBit)
{
  std::mt19937_64 random(7);
  recon::LoopSoup soup;
  for (int loop = 0; loop < 20; ++loop)
  {
    recon::LoopSoup::Chain chain;
    chain.Closed = true;
    const double z = loop + std::ldexp(static_cast<double>(random()), -65);
    for (int i = 0; i < 30; ++i)
    {
      chain.Points.push_back(static_cast<int>(soup.Points.size()));
      const double scale = std::pow(10.0, static_cast<double>(random() % 40) - 58);
      soup.Points.push_back({ (static_cast<double>(random()) - 9e18) * scale,
        std::numeric_limits<double>::denorm_min() * static_cast<double>(random() % 5), z });
    }
    soup.Chains.push_back(chain);
  }
  EXPECT_TRUE(this->Write("round trip.cnt", soup).empty());
  EXPECT_TRUE(Equal(this->Read(this->Name("round trip.cnt")).Soup, soup));
}

TEST_F(NUAGESFormatter, WritesSectionsByHeightAndLeavesOutTheClosingPoint)
{
  recon::LoopSoup soup = SquareAt(2);
  soup.Points.push_back({ 0, 0, 2 }); // the first point again, under another index, and twice
  soup.Chains[0].Points.insert(soup.Chains[0].Points.end(), { 4, 4 });
  for (const recon::Point3& p : { recon::Point3{ 5, 5, 1 }, { 6, 5, 1 }, { 6, 6, 1 } })
  {
    soup.Points.push_back(p);
  }
  soup.Chains.push_back({ { 5, 6, 7 }, true, 1 });
  this->Write("a.cnt", soup);
  EXPECT_EQ(Bytes(this->Name("a.cnt")),
    "S 2\nv 3 z 1\n{\n5 5\n6 5\n6 6\n}\nv 4 z 2\n{\n0 0\n1 0\n1 1\n0 1\n}\n");
}

TEST_F(NUAGESFormatter, SaysWhereItMovedAPlane)
{
  recon::LoopSoup soup = SquareAt(1);
  soup.Points[2][2] = 1 + 1e-9;
  const std::vector<std::string> report = this->Write("a.cnt", soup);
  ASSERT_EQ(report.size(), 1u);
  EXPECT_NE(report[0].find("not all at one z"), std::string::npos);
}

TEST_F(NUAGESFormatter, WhatCannotBeWritten)
{
  recon::LoopSoup soup;
  soup.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0.5 } };
  soup.Chains.push_back({ { 0, 1, 2 }, true, 0 });
  EXPECT_NE(this->WriteSentence(soup).find("not perpendicular to z"), std::string::npos);
  soup.Points[2][2] = 0;
  soup.Points[1][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(this->WriteSentence(soup).find("no finite number"), std::string::npos);
  soup.Points[1][0] = 1;
  soup.Chains[0].Closed = false;
  EXPECT_NE(this->WriteSentence(soup).find("it is open"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(this->Name("out.cnt")));
  soup.Chains[0].Closed = true;
  const std::string folder = this->Name("no such folder/out.cnt");
  ExpectSentence(
    SentenceOf([&] { recon::WriteNUAGES(folder, soup, this->Monitor); }), folder, "Cannot write");
  EXPECT_TRUE(this->WriteSentence(soup).empty());
}
