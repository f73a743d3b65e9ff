// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever comes between: the old file is there as it was, or the new one is, whole.
#include "Readers/DICOM/StructureSetBuilder.h"
#include "Readers/ReaderTesting.h"

#include "BRep/BRepFormatter.h"
#include "BRep/BRepParser.h"
#include "DICOM/StructureSetFile.h"
#include "DICOM/StructureSetFormatter.h"
#include "NUAGES/NUAGESFormatter.h"
#include "NUAGES/NUAGESParser.h"
#include "Table/ContourTableFormatter.h"
#include "Table/ContourTableParser.h"

#include <csignal>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace readertesting;

namespace
{
recon::Monitor Silent;

/// Levels of the two versions of a file.
constexpr int Few = 2;
constexpr int Many = 6;

recon::LoopSoup Stack(int levels)
{
  recon::LoopSoup soup;
  for (int level = 0; level < levels; ++level)
  {
    std::vector<recon::Point3> points;
    for (int i = 0; i < 1000; ++i)
    {
      const double angle = i * 6.283 / 1000;
      points.push_back({ std::cos(angle), std::sin(angle), 1.0 * level });
    }
    soup.Append(points);
  }
  return soup;
}

/// A format: how so many levels are written, and how many a file that can be read to its end has.
struct Format
{
  const char* Name;
  std::function<void(const std::string&, int)> Write;
  std::function<int(const std::string&)> Levels;
};

void WriteTable(const std::string& name, int levels)
{
  recon::TracedObject object;
  object.Name = "all";
  object.Soup = Stack(levels);
  for (int level = 0; level < levels; ++level)
  {
    object.Slices.push_back(level);
  }
  recon::TracedFile file;
  file.Objects.push_back(object);
  recon::WriteContourTable(name, file, Silent);
}

void WriteStructureSet(const std::string& name, int levels)
{
  recon::WrittenROI roi;
  roi.Description.Name = "all";
  const recon::LoopSoup soup = Stack(levels);
  for (const recon::LoopSoup::Chain& chain : soup.Chains)
  {
    recon::WrittenContour contour;
    contour.GeometricType = "CLOSED_PLANAR";
    for (const int p : chain.Points)
    {
      contour.Points.push_back(soup.Points[static_cast<std::size_t>(p)]);
    }
    roi.Contours.push_back(contour);
  }
  recon::WriteStructureSet(name, { roi }, {}, Silent);
}

/// A level is a tetrahedron a thousand times here.
void WriteBRep(const std::string& name, int levels)
{
  recon::TriangleMesh mesh;
  for (int i = 0; i < 1000 * levels; ++i)
  {
    const double x = 3.0 * i;
    const int p = 4 * i;
    mesh.Points.insert(
      mesh.Points.end(), { { x, 0, 0 }, { x + 1, 0, 0 }, { x, 1, 0 }, { x, 0, 1 } });
    mesh.Triangles.insert(mesh.Triangles.end(),
      { { p, p + 2, p + 1 }, { p, p + 1, p + 3 }, { p + 1, p + 2, p + 3 }, { p + 2, p, p + 3 } });
  }
  std::vector<int> missing;
  recon::WriteBRep(name, recon::MakeBRep(mesh, {}, {}, missing, Silent), Silent);
}

std::vector<Format> Formats()
{
  const auto chains = [](const recon::LoopSoup& soup)
  { return static_cast<int>(soup.Chains.size()); };
  return {
    { "cnt",
      [](const std::string& name, int levels) { recon::WriteNUAGES(name, Stack(levels), Silent); },
      [chains](const std::string& name) { return chains(recon::ReadNUAGES(name, Silent).Soup); } },
    { "csv", WriteTable,
      [chains](const std::string& name)
      { return chains(recon::ReadContourTable(name, {}, Silent).Objects.at(0).Soup); } },
    { "dcm", WriteStructureSet,
      [chains](const std::string& name)
      { return chains(recon::StructureSetFile(name).ReadContours(0, Silent).File.Soup); } },
    { "brep", WriteBRep,
      [](const std::string& name) {
        return static_cast<int>(recon::ReadBRep(name, Silent).ShellSets.at(0).Shells.size()) / 1000;
      } },
  };
}

class WholeFiles
  : public Folder
  , public testing::WithParamInterface<int>
{
protected:
  const Format Of = Formats()[static_cast<std::size_t>(GetParam())];
  const std::string File = this->Folder::Name(std::string("file.") + this->Of.Name);

  /// A process that writes the one and the other in turn; its number.
  pid_t WriteForEver(rlim_t mostBytes = RLIM_INFINITY)
  {
    const pid_t child = fork();
    if (child != 0)
    {
      return child;
    }
    const rlimit limit{ mostBytes, RLIM_INFINITY };
    setrlimit(RLIMIT_FSIZE, &limit);
    for (int levels = Many;; levels = levels == Many ? Few : Many)
    {
      this->Of.Write(this->File, levels);
    }
  }

  void ExpectWhole(const std::string& when)
  {
    const int levels = this->Of.Levels(this->File);
    EXPECT_TRUE(levels == Few || levels == Many) << levels << " levels after " << when;
  }

  int NumberOfFiles() const
  {
    const auto folder = std::filesystem::path(this->File).parent_path();
    return static_cast<int>(std::distance(
      std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
  }
};
}

TEST_P(WholeFiles, AreThereAfterEveryKill)
{
  constexpr int kills = 25; // of each of four formats
  this->Of.Write(this->File, Few);
  std::mt19937 random(1);
  for (int i = 0; i < kills; ++i)
  {
    const pid_t child = this->WriteForEver();
    usleep(random() % 20000);
    ASSERT_EQ(kill(child, SIGKILL), 0);
    ASSERT_EQ(waitpid(child, nullptr, 0), child);
    this->ExpectWhole("kill " + std::to_string(i));
  }
}

TEST_P(WholeFiles, AreThereAfterAnEndInTheMidstOfAWrite)
{
  this->Of.Write(this->File, Many);
  const auto size = std::filesystem::file_size(this->File);
  for (int i = 0; i < 10; ++i)
  {
    // The system ends whoever writes more than that.
    const pid_t child = this->WriteForEver(1 + size * static_cast<unsigned int>(i) / 20);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGXFSZ) << status;
    this->ExpectWhole("end at " + std::to_string(i) + " twentieths");
    EXPECT_EQ(this->NumberOfFiles(), 2 + i)
      << "what was written stays beside it, by a name of its own";
  }
}

TEST_P(WholeFiles, AreOneWritersOrTheOthers)
{
  const auto write = [this](int levels)
  {
    for (int i = 0; i < 10; ++i)
    {
      this->Of.Write(this->File, levels);
    }
  };
  write(Few);
  std::thread one(write, Few);
  std::thread other(write, Many);
  for (int i = 0; i < 20; ++i)
  {
    const int levels = this->Of.Levels(this->File);
    EXPECT_TRUE(levels == Few || levels == Many) << levels;
  }
  one.join();
  other.join();
  EXPECT_EQ(this->NumberOfFiles(), 1);
}

TEST_P(WholeFiles, StayAsTheyWereOnAFullDisk)
{
  this->Of.Write(this->File, Few);
  const std::string before = Bytes(this->File);
  rlimit usual{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &usual), 0);
  const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
  for (const rlim_t size : { 0, 100, 20000, 65536 })
  {
    rlimit limit = usual;
    limit.rlim_cur = size;
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
    const std::string sentence = SentenceOf([this] { this->Of.Write(this->File, Many); });
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &usual), 0);
    ExpectSentence(sentence, this->File, "full");
    EXPECT_EQ(Bytes(this->File), before);
    EXPECT_EQ(this->NumberOfFiles(), 1) << "a part is left";
  }
  std::signal(SIGXFSZ, ignored);
}

TEST_P(WholeFiles, AreNotWrittenWhereNobodyMay)
{
  namespace fs = std::filesystem;
  const std::string closed = this->Folder::Name("closed");
  fs::create_directory(closed);
  fs::permissions(closed, fs::perms::owner_read | fs::perms::owner_exec);
  if (std::ofstream(closed + "/probe").good())
  {
    fs::permissions(closed, fs::perms::owner_all);
    GTEST_SKIP() << "this user may write anywhere (root)";
  }
  const std::string name = closed + "/file";
  ExpectSentence(
    SentenceOf([&] { this->Of.Write(name, Few); }), name, "its folder cannot be written to");
  fs::permissions(closed, fs::perms::owner_all);
}

INSTANTIATE_TEST_SUITE_P(Formats, WholeFiles, testing::Range(0, 4),
  [](const auto& each) { return Formats()[static_cast<std::size_t>(each.param)].Name; });
