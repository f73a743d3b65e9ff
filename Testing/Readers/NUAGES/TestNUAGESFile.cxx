// SPDX-License-Identifier: GPL-3.0-or-later
#include "Readers/ReaderTesting.h"

#include "NUAGES/NUAGESFormatter.h"
#include "NUAGES/NUAGESParser.h"

#include <clocale>
#include <cmath>
#include <limits>
#include <ostream>
#include <set>

using namespace readertesting;

namespace
{
class NUAGESFile : public Folder
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
  recon::Monitor Monitor;
};

const char* const TwoSections = "S 2\n"
                                "v 7 z 0.25\n{\n0 0\n4 0\n4 4\n0 4\n}\n{\n1 1\n1 2\n2 1\n}\n"
                                "v 3 z -1.5e1\n{\n+1 .5\n2. 1\n3 7\n}\n";

recon::LoopSoup SquareAt(double z)
{
  recon::LoopSoup soup;
  soup.Points = { { 0, 0, z }, { 1, 0, z }, { 1, 1, z }, { 0, 1, z } };
  soup.Chains.push_back({ { 0, 1, 2, 3 }, true, 0 });
  return soup;
}

struct Expected
{
  const char* Name;
  std::size_t Sections;
  std::size_t Contours;
  std::size_t Points;
};

/// The name of the test is that of the file.
void PrintTo(const Expected& expected, std::ostream* os)
{
  *os << expected.Name;
}

class RealNUAGESFile : public testing::TestWithParam<Expected>
{
};
}

TEST_F(NUAGESFile, ReadsSectionsInTheOrderOfTheFile)
{
  const recon::ContourFile file = this->Read(this->Folder::Write("two sections.cnt", TwoSections));
  ASSERT_EQ(file.Soup.Chains.size(), 3u);
  ASSERT_EQ(file.Soup.Points.size(), 10u);
  EXPECT_EQ(file.Soup.Chains[1].Points, (std::vector<int>{ 4, 5, 6 }));
  EXPECT_TRUE(file.Soup.Chains[2].Closed);
  EXPECT_EQ(file.Soup.Points[2], (recon::Point3{ 4, 4, 0.25 }));
  EXPECT_EQ(file.Soup.Points[7], (recon::Point3{ 1, 0.5, -15 }));
  EXPECT_TRUE(file.Report.empty());
}

TEST_F(NUAGESFile, ReadsSmallSAndOtherLineEndingsAndOneLine)
{
  const recon::LoopSoup expected = this->Read(this->Folder::Write("a.cnt", TwoSections)).Soup;
  std::string windows;
  std::string oneLine;
  for (const char c : std::string(TwoSections))
  {
    windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    oneLine += c == '\n' ? '\t' : c;
  }
  oneLine[0] = 's';
  EXPECT_TRUE(Equal(this->Read(this->Folder::Write("b.cnt", windows)).Soup, expected));
  EXPECT_TRUE(Equal(this->Read(this->Folder::Write("c.cnt", oneLine)).Soup, expected));
  EXPECT_TRUE(
    Equal(this->Read(this->Folder::Write("d.cnt", "\xEF\xBB\xBF" + windows)).Soup, expected));
}

TEST_F(NUAGESFile, KeepsContoursThatAreTooSmallAndReportsEmptyOnes)
{
  const recon::ContourFile file =
    this->Read(this->Folder::Write("a.cnt", "S 2 v 3 z 0 { 1 1 } { } { 0 0 1 1 } v 0 z 1"));
  ASSERT_EQ(file.Soup.Chains.size(), 2u);
  EXPECT_EQ(file.Soup.Chains[0].Points.size(), 1u);
  EXPECT_EQ(file.Soup.Chains[1].Points.size(), 2u);
  ASSERT_EQ(file.Report.size(), 1u);
  EXPECT_EQ(file.Report[0], "Section 1, contour 2: left out, it has no vertices.");
}

TEST_F(NUAGESFile, DoesNotDependOnTheLocale)
{
  // A locale with a decimal comma, where the machine has one; the number must not end at the point.
  const std::string before = std::setlocale(LC_ALL, nullptr);
  const char* found = nullptr;
  for (const char* name : { "de_DE.UTF-8", "fr_FR.UTF-8", "de_DE.utf8" })
  {
    found = found ? found : std::setlocale(LC_ALL, name);
  }
  if (!found)
  {
    GTEST_SKIP() << "this machine has no locale with a decimal comma";
  }
  const recon::ContourFile file = this->Read(this->Folder::Write("a.cnt", TwoSections));
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_EQ(file.Soup.Points[0][2], 0.25);
}

TEST_F(NUAGESFile, RoundTripIsExactToTheLastBit)
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

TEST_F(NUAGESFile, WritesSectionsByHeightAndLeavesOutTheClosingPoint)
{
  recon::LoopSoup soup = SquareAt(2);
  soup.Points.push_back({ 0, 0, 2 }); // the first point again, under another index
  soup.Chains[0].Points.push_back(4);
  for (const recon::Point3& p : { recon::Point3{ 5, 5, 1 }, { 6, 5, 1 }, { 6, 6, 1 } })
  {
    soup.Points.push_back(p);
  }
  soup.Chains.push_back({ { 5, 6, 7 }, true, 1 });
  this->Write("a.cnt", soup);
  EXPECT_EQ(Bytes(this->Name("a.cnt")),
    "S 2\nv 3 z 1\n{\n5 5\n6 5\n6 6\n}\nv 4 z 2\n{\n0 0\n1 0\n1 1\n0 1\n}\n");
}

TEST_F(NUAGESFile, SaysWhereItMovedAPlane)
{
  recon::LoopSoup soup = SquareAt(1);
  soup.Points[2][2] = 1 + 1e-9;
  const std::vector<std::string> report = this->Write("a.cnt", soup);
  ASSERT_EQ(report.size(), 1u);
  EXPECT_NE(report[0].find("not all at one z"), std::string::npos);
}

TEST_F(NUAGESFile, IsToldByContent)
{
  EXPECT_TRUE(recon::IsNUAGES(this->Folder::Write("a.txt", TwoSections)));
  EXPECT_TRUE(recon::IsNUAGES(this->Folder::Write("b.cnt", "s\r\n1 v\t3")));
  EXPECT_FALSE(recon::IsNUAGES(this->Folder::Write("c.cnt", "Some text")));
  EXPECT_FALSE(recon::IsNUAGES(this->Folder::Write("d.cnt", "S many v 3 z 0")));
  EXPECT_FALSE(recon::IsNUAGES(this->Folder::Write("e.cnt", RandomBytes(4096, 1))));
  EXPECT_FALSE(recon::IsNUAGES(this->Folder::Write("f.cnt", "")));
  EXPECT_FALSE(recon::IsNUAGES(this->Name("absent.cnt")));
  EXPECT_FALSE(recon::IsNUAGES(this->Name("")));
}

TEST_P(RealNUAGESFile, HasTheCountsOfItsTable)
{
  const std::string fileName = Shared(std::string("cnt/") + GetParam().Name);
  CONTOUR_SKIP_UNLESS(fileName);
  recon::Monitor monitor;
  const recon::ContourFile file = recon::ReadNUAGES(fileName, monitor);
  EXPECT_EQ(file.Soup.Chains.size(), GetParam().Contours);
  EXPECT_EQ(file.Soup.Points.size(), GetParam().Points);
  std::set<double> heights;
  for (const recon::Point3& p : file.Soup.Points)
  {
    heights.insert(p[2]);
  }
  EXPECT_EQ(heights.size(), GetParam().Sections);
  EXPECT_TRUE(file.Report.empty());
}

INSTANTIATE_TEST_SUITE_P(Shared, RealNUAGESFile,
  testing::Values(Expected{ "manytomany.cnt", 2, 6, 960 },
    Expected{ "amygdala_label3.cnt", 74, 185, 12812 },
    Expected{ "frog_label3.cnt", 61, 143, 11866 },
    Expected{ "spl_left_hippocampus.cnt", 26, 69, 2720 },
    Expected{ "sainthelens_100m.cnt", 17, 68, 20994 },
    Expected{ "sainthelens_unequal.cnt", 13, 78, 19782 }));
