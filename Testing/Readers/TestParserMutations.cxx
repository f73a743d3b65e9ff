// SPDX-License-Identifier: GPL-3.0-or-later
// Files of others with bytes, numbers and pieces exchanged: whatever comes of it, a parser ends in a
// sentence or in contours that hold together.
#include "Readers/ReaderTesting.h"
#include "Readers/Soundness.h"
#include "Readers/TraceBuilder.h"

#include "BRep/BRepParser.h"
#include "CurveNetwork/CurveNetworkParser.h"
#include "DICOM/StructureSetFile.h"
#include "ImageJ/ImageJParser.h"
#include "IMOD/IMODParser.h"
#include "NUAGES/NUAGESParser.h"
#include "Reconstruct/ReconstructParser.h"
#include "SVG/SVGParser.h"
#include "Table/ContourTableParser.h"
#include "TestPaths.h"

#include <algorithm>

using namespace readertesting;

namespace
{
/// Changes a file a little, as accidents and other programs do.
class Mutator
{
public:
  explicit Mutator(unsigned int seed) : Random(seed) {}

  std::string Mutated(std::string bytes)
  {
    for (std::size_t i = 0; i <= this->Below(3); ++i)
    {
      this->Mutate(bytes);
    }
    return bytes;
  }

private:
  std::size_t Below(std::size_t end) { return end == 0 ? 0 : this->Random() % end; }

  void Mutate(std::string& bytes)
  {
    static const std::vector<std::string> pieces{ "\\", "nan", "-", "1e999", "\x1b$B", "\xff\xff",
      std::string(4, '\0'), "\n", " ", "99999999999", "\xfe\xff\x00\xe0", "{", "h0", "#" };
    const std::size_t at = this->Below(bytes.size());
    const std::size_t length = 1 + this->Below(64);
    switch (this->Below(6))
    {
      case 0:
        bytes[at] = static_cast<char>(this->Random() & 0xff);
        break;
      case 1:
        bytes.erase(at, length);
        break;
      case 2:
        bytes.insert(at, bytes.substr(this->Below(bytes.size()), length));
        break;
      case 3:
        bytes.replace(at, length, bytes.substr(this->Below(bytes.size()), length));
        break;
      case 4:
        bytes.insert(at, pieces[this->Below(pieces.size())]);
        break;
      default:
        bytes.resize(at + 1);
    }
    bytes += bytes.empty() ? "x" : "";
  }

  std::mt19937 Random;
};

class ParserMutations : public Folder
{
protected:
  /// Reads so many mutations of a file; how many ended in a sentence.
  template <typename Parser>
  int Try(const std::string& fileName, int count, Parser parse)
  {
    const std::string whole = Bytes(fileName);
    int sentences = 0;
    for (int i = 0; i < count; ++i)
    {
      SCOPED_TRACE(fileName + ", seed " + std::to_string(i));
      const std::string mutated =
        this->Write("mutated", Mutator(static_cast<unsigned int>(i)).Mutated(whole));
      const std::string sentence = SentenceOf([&] { parse(mutated); });
      if (!sentence.empty())
      {
        ExpectSentence(sentence, mutated, "Cannot read");
        ++sentences;
      }
    }
    return sentences;
  }
  recon::Monitor Monitor;
};

std::vector<std::string> FilesIn(const std::string& folder, const std::string& extension)
{
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    if (entry.path().extension() == extension)
    {
      files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

const std::string Own = recon::testing::OwnPath("Data");
}

TEST_F(ParserMutations, StructureSets)
{
  const std::string folder = Shared("faults/rt");
  CONTOUR_SKIP_UNLESS(folder);
  int sentences = 0;
  int tried = 0;
  for (const std::string& fileName : FilesIn(folder, ".dcm"))
  {
    constexpr int each = 60;
    tried += each;
    sentences += this->Try(fileName, each,
      [this](const std::string& mutated)
      {
        recon::StructureSetFile::IsStructureSet(mutated);
        recon::StructureSetFile file(mutated);
        EXPECT_EQ(FaultOf(file, this->Monitor), "");
      });
  }
  EXPECT_GT(sentences, 0);
  EXPECT_LT(sentences, tried);
}

TEST_F(ParserMutations, NUAGES)
{
  std::vector<std::string> files = FilesIn(Own, ".cnt");
  const std::string folder = Shared("faults/other");
  if (!folder.empty())
  {
    const std::vector<std::string> more = FilesIn(folder, ".cnt");
    files.insert(files.end(), more.begin(), more.end());
  }
  ASSERT_FALSE(files.empty());
  for (const std::string& fileName : files)
  {
    this->Try(fileName, 40,
      [this](const std::string& mutated)
      {
        recon::IsNUAGES(mutated);
        EXPECT_EQ(FaultOf(recon::ReadNUAGES(mutated, this->Monitor)), "");
      });
  }
}

TEST_F(ParserMutations, CurveNetworks)
{
  const std::string cross =
    "CSLC\n2 2\n\n1 4 1 0 0 1 -2\n\n0 0 2\n4 0 2\n4 4 2\n0 4 2\n\n4 1 0 1 2 3\n"
    "2 7 2 0 0 1 -3\n0 0 3\n4 0 3\n4 4 3\n0 4 3\n1 1 3\n1 2 3\n2 1 3\n"
    "4 1 0 1 2 3\n3h0 2 4 5 6\n";
  const std::string network = "1\n0 0 2 6\n6 7\n0 0 3\n1 0 3\n2 0 3\n2 1 3\n1 1 3\n0 1 3\n"
                              "0 1 1 0\n1 2 2 0\n2 3 2 0\n3 4 2 0\n4 5 1 0\n5 0 1 0\n1 4 1 2\n";
  for (const std::string& text : { cross, network })
  {
    const std::string fileName = this->Folder::Write("whole", text);
    const int sentences = this->Try(fileName, 500,
      [this](const std::string& mutated)
      { EXPECT_EQ(FaultOf(recon::ReadCurveNetwork(mutated, this->Monitor)), ""); });
    EXPECT_GT(sentences, 0);
    EXPECT_LT(sentences, 500);
  }
}

TEST_F(ParserMutations, BReps)
{
  const int sentences = this->Try(Own + "/example.brep", 500,
    [this](const std::string& mutated)
    {
      recon::IsBRep(mutated);
      recon::ReadBRep(mutated, this->Monitor);
    });
  EXPECT_GT(sentences, 0);
  EXPECT_LT(sentences, 500);
}

namespace
{
const std::vector<recon::Point3> Corners{ { 0, 0, 4 }, { 8, 0, 4 }, { 8, 8, 4 }, { 0, 8, 4 } };
const std::string Model = tracebuilder::IMODHeader(2) + tracebuilder::IMODObject("axon", 2) +
  tracebuilder::IMODContour(Corners) + tracebuilder::IMODContour(Corners, 8) +
  tracebuilder::IMODObject("spots", 1, 512) + tracebuilder::IMODContour(Corners) + "IEOF";
const std::string ROIs =
  tracebuilder::ZIP({ { "a.roi", tracebuilder::ROI({ { 1, 2 }, { 5, 2 }, { 5, 9 } }, 3, "first") },
    { "b.roi", tracebuilder::ROI({}, 0, "oval", 2, 4) } });
const std::string Layers =
  "<svg xmlns:i=\"http://www.inkscape.org/namespaces/inkscape\" width=\"9mm\" viewBox=\"0 0 9 9\">"
  "<g i:groupmode=\"layer\" transform=\"rotate(9) scale(2)\"><path d=\"M1 1C2 3 4 5 6 7S9 9 8 8q1 "
  "2 3 "
  "4t5 6A1 2 3 0 1 9 9z\"/></g><g i:groupmode=\"layer\"><circle r=\"4\" i:label=\"a\"/></g></svg>";
const std::string Rows = "object,slice,contour,x,y,z\na,1,1,0,0,0\na,1,1,1,0,0\na,1,1,1,1,0\n"
                         "\"b, c\",2,1,0,0,1\n\"b, c\",2,1,1,0,1\n\"b, c\",2,1,1,1,1\n";
}

TEST_F(ParserMutations, Traces)
{
  const recon::SliceStack stack;
  const std::vector<std::pair<std::string, std::function<recon::TracedFile(const std::string&)>>>
    all{
      { Model, [&](const std::string& name) { return recon::ReadIMOD(name, this->Monitor); } },
      { ROIs,
        [&](const std::string& name) { return recon::ReadImageJ(name, stack, this->Monitor); } },
      { Layers,
        [&](const std::string& name) { return recon::ReadSVG({ name }, stack, this->Monitor); } },
      { Rows,
        [&](const std::string& name)
        { return recon::ReadContourTable(name, stack, this->Monitor); } },
      { tracebuilder::JSONSeries,
        [&](const std::string& name) { return recon::ReadReconstruct(name, this->Monitor); } },
    };
  for (const auto& [whole, read] : all)
  {
    const std::string fileName = this->Folder::Write("whole", whole);
    const int sentences = this->Try(fileName, 400,
      [&, &parse = read](const std::string& mutated) { EXPECT_EQ(FaultOf(parse(mutated)), ""); });
    EXPECT_GT(sentences, 0);
    EXPECT_LT(sentences, 400);
  }
}

TEST_F(ParserMutations, Sections)
{
  this->Folder::Write(
    "s.0", tracebuilder::SectionFile(0, tracebuilder::NoTransform, "0 0, 1 0, 1 1,"));
  const std::string series = this->Folder::Write("s.ser", tracebuilder::SeriesFile);
  const std::string section = tracebuilder::SectionFile(
    1, "dim=\"6\" xcoef=\"0 1 .1 .1 .1 .1\" ycoef=\"0 0 1 .1 .1 .1\"", "0 0, 1 0, 1 1,");
  for (unsigned int seed = 0; seed < 400; ++seed)
  {
    SCOPED_TRACE(seed);
    this->Folder::Write("s.1", Mutator(seed).Mutated(section));
    const recon::TracedFile file = recon::ReadReconstruct(series, this->Monitor);
    ASSERT_FALSE(file.Objects.empty());
    EXPECT_EQ(FaultOf(file), "");
  }
}
