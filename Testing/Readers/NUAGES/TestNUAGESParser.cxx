// SPDX-License-Identifier: GPL-3.0-or-later
#include "Readers/ReaderTesting.h"

#include "NUAGES/NUAGESParser.h"

#include <clocale>
#include <ostream>
#include <set>

using namespace readertesting;

namespace
{
class NUAGESParser : public Folder
{
protected:
  recon::ContourFile Read(const std::string& fileName)
  {
    return recon::ReadNUAGES(fileName, this->Monitor);
  }
  recon::Monitor Monitor;
};

const char* const TwoSections = "S 2\n"
                                "v 7 z 0.25\n{\n0 0\n4 0\n4 4\n0 4\n}\n{\n1 1\n1 2\n2 1\n}\n"
                                "v 3 z -1.5e1\n{\n+1 .5\n2. 1\n3 7\n}\n";

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

class RealNUAGESParser : public testing::TestWithParam<Expected>
{
};
}

TEST_F(NUAGESParser, ReadsSectionsInTheOrderOfTheFile)
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

TEST_F(NUAGESParser, ReadsSmallSAndOtherLineEndingsAndOneLine)
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

TEST_F(NUAGESParser, KeepsContoursThatAreTooSmallAndReportsEmptyOnes)
{
  const recon::ContourFile file =
    this->Read(this->Folder::Write("a.cnt", "S 2 v 3 z 0 { 1 1 } { } { 0 0 1 1 } v 0 z 1"));
  ASSERT_EQ(file.Soup.Chains.size(), 2u);
  EXPECT_EQ(file.Soup.Chains[0].Points.size(), 1u);
  EXPECT_EQ(file.Soup.Chains[1].Points.size(), 2u);
  ASSERT_EQ(file.Report.size(), 1u);
  EXPECT_EQ(file.Report[0], "Section 1, contour 2: left out, it has no vertices.");
}

TEST_F(NUAGESParser, DoesNotDependOnTheLocale)
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

TEST_F(NUAGESParser, IsToldByContent)
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

TEST_P(RealNUAGESParser, HasTheCountsOfItsTable)
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

INSTANTIATE_TEST_SUITE_P(Shared, RealNUAGESParser,
  testing::Values(Expected{ "manytomany.cnt", 2, 6, 960 },
    Expected{ "amygdala_label3.cnt", 74, 185, 12812 },
    Expected{ "frog_label3.cnt", 61, 143, 11866 },
    Expected{ "spl_left_hippocampus.cnt", 26, 69, 2720 },
    Expected{ "sainthelens_100m.cnt", 17, 68, 20994 },
    Expected{ "sainthelens_unequal.cnt", 13, 78, 19782 }));
