// SPDX-License-Identifier: GPL-3.0-or-later
#include "Readers/ReaderTesting.h"

#include "CurveNetwork/CurveNetworkParser.h"

using namespace readertesting;

namespace
{
const std::string CSL = "CSLC\n1 2\n\n1 7 2 0 0 1 -2\n\n0 0 2\n4 0 2\n4 4 2\n0 4 2\n1 1 2\n1 2 2\n"
                        "2 1 2\n\n4 1 0 1 2 3\n3h0 1 4 5 6\n";
const std::string Contour = "1\n0 0 1 0\n3 3\n0 0 0\n1 0 0\n1 1 0\n0 1 1 0\n1 2 1 0\n2 0 1 0\n";

class CurveNetworkParserInvalid : public Folder
{
protected:
  std::string Sentence(const std::string& bytes)
  {
    const std::string fileName = this->Write("bad network", bytes);
    return SentenceOf([&] { recon::ReadCurveNetwork(fileName, this->Monitor); });
  }
  void Expect(const std::string& bytes, const std::string& part)
  {
    ExpectSentence(this->Sentence(bytes), this->Name("bad network"), part);
  }
  /// The file with one of its tokens replaced, the first where there are several.
  static std::string With(std::string bytes, const std::string& from, const std::string& to)
  {
    const std::size_t at = bytes.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return bytes.replace(at, from.size(), to);
  }
  recon::Monitor Monitor;
};
}

TEST_F(CurveNetworkParserInvalid, TruncatedAnywhere)
{
  for (const std::string& whole : { CSL, Contour })
  {
    ASSERT_EQ(this->Sentence(whole), "");
    for (std::size_t size = 0; size + 1 < whole.size(); ++size)
    {
      EXPECT_FALSE(this->Sentence(whole.substr(0, size)).empty())
        << "whole at " << size << " bytes?";
    }
  }
}

TEST_F(CurveNetworkParserInvalid, EmptyAbsentBinaryOrAnotherFormat)
{
  this->Expect("", "the file is empty");
  this->Expect("solid name\n", "expected a cross-section set that begins with 'CSLC'");
  this->Expect("S 1\nv 3 z 0\n{\n0 0\n1 0\n1 1\n}\n", "expected a cross-section set");
  ExpectSentence(
    SentenceOf([&] { recon::ReadCurveNetwork(this->Name("absent.csl"), this->Monitor); }),
    this->Name("absent.csl"), "no such file");
  for (unsigned int seed = 0; seed < 10; ++seed)
  {
    this->Expect(RandomBytes(4096, seed), "binary");
    this->Expect("CSLC\n1 2\n" + RandomBytes(4096, seed), "binary");
    this->Expect(Contour + RandomBytes(4096, seed), "binary");
  }
}

TEST_F(CurveNetworkParserInvalid, CSLNamesLineAndWhatWasExpected)
{
  this->Expect(With(CSL, "1 7 2 0 0 1", "1 7 2 0 0 up"),
    "line 4: expected A, B and C of the plane, found 'up'");
  this->Expect(
    With(CSL, "4 4 2", "4 nan 2"), "line 8: expected x, y and z of a vertex, found 'nan'");
  this->Expect(
    With(CSL, "3h0 1", "3x0 1"), "line 15: expected the number of vertices of a component");
  this->Expect(With(CSL, "3h0 1", "3h7 1"), "line 15: component 1 is a hole of component 7");
  this->Expect(With(CSL, "3h0 1", "3h1 1"), "component 1 is a hole of component 1");
  this->Expect(With(CSL, "4 1 0 1 2 3", "4h1 1 0 1 2 3"), "is a hole of itself, by way of others");
  this->Expect(With(CSL, "0 1 2 3\n", "0 1 2 7\n"), "line 14: vertex index 7 is out of range");
  this->Expect(With(CSL, "0 1 2 3\n", "0 1 -2 3\n"), "line 14: vertex index -2 is out of range");
  this->Expect(CSL + "2 0 0 0 0 1 0\n", "line 16: expected the end of the file after 1 planes");
}

TEST_F(CurveNetworkParserInvalid, ContourNamesLineAndWhatWasExpected)
{
  this->Expect(
    With(Contour, "1 1 0\n", "1 inf 0\n"), "line 6: expected x, y and z of a vertex, found 'inf'");
  this->Expect(With(Contour, "1 1 0\n", "1 -1e170 0\n"),
    "line 6: a vertex is farther from the origin than 1e60.");
  this->Expect(With(Contour, "1 2 1 0", "1 3 1 0"), "line 8: vertex index 3 is out of range");
  this->Expect(
    With(Contour, "1 2 1 0", "1 2 1 -1"), "line 8: expected a material of 0 (outside) or more");
  this->Expect(
    With(Contour, "1 2 1 0", "1 2 1 x"), "line 8: expected the material beside an edge, found 'x'");
  this->Expect(Contour + "7\n", "line 10: expected the end of the file after 1 planes, found '7'");
}

TEST_F(CurveNetworkParserInvalid, HugeCountsAreRefusedBeforeAnythingIsAllocated)
{
  const char* const part = "more than the rest of the file can hold";
  this->Expect(With(CSL, "1 2\n", "2000000000 2\n"), part);
  this->Expect(With(CSL, "1 7 2", "1 2000000000 2"), part);
  this->Expect(With(CSL, "1 7 2", "1 7 2000000000"), part);
  this->Expect(With(CSL, "4 1 0", "2000000000 1 0"), part);
  this->Expect(With(Contour, "1\n0 0", "2000000000\n0 0"), part);
  this->Expect(With(Contour, "3 3\n", "2000000000 3\n"), part);
  this->Expect(With(Contour, "3 3\n", "3 2000000000\n"), part);
}

TEST_F(CurveNetworkParserInvalid, Mutated)
{
  std::mt19937 random(11);
  for (int i = 0; i < 500; ++i)
  {
    std::string bytes = i % 2 ? CSL : Contour;
    bytes[random() % bytes.size()] = "0123456789 -.hx\n"[random() % 16];
    this->Sentence(bytes); // a sentence or none, but nothing worse
  }
}
