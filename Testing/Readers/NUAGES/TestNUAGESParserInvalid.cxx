// SPDX-License-Identifier: GPL-3.0-or-later
#include "Readers/ReaderTesting.h"

#include "NUAGES/NUAGESParser.h"

#include <cmath>
#include <limits>

using namespace readertesting;

namespace
{
const std::string Whole = "S 2\nv 4 z 0\n{\n0 0\n4 0\n4 4\n0 4\n}\nv 3 z 1\n{\n1 1\n2 1\n2 2\n}\n";

class NUAGESParserInvalid : public Folder
{
protected:
  std::string Sentence(const std::string& bytes)
  {
    const std::string fileName = this->Write("bad file.cnt", bytes);
    return SentenceOf([&] { recon::ReadNUAGES(fileName, this->Monitor); });
  }
  void Expect(const std::string& bytes, const std::string& part)
  {
    const std::string sentence = this->Sentence(bytes);
    ExpectSentence(sentence, this->Name("bad file.cnt"), part);
  }
  recon::Monitor Monitor;
};
}

TEST_F(NUAGESParserInvalid, TruncatedAnywhere)
{
  // The last line break may go; with anything else the file is not whole.
  for (std::size_t size = 0; size + 1 < Whole.size(); ++size)
  {
    EXPECT_FALSE(this->Sentence(Whole.substr(0, size)).empty()) << "whole at " << size << " bytes?";
  }
  EXPECT_TRUE(this->Sentence(Whole.substr(0, Whole.size() - 1)).empty());
  EXPECT_TRUE(this->Sentence(Whole).empty());
}

TEST_F(NUAGESParserInvalid, EmptyAbsentOrAFolder)
{
  this->Expect("", "the file is empty");
  this->Expect(" \n\n", "the file is empty");
  for (const std::string& fileName : { this->Name("absent.cnt"), this->Name("") })
  {
    ExpectSentence(
      SentenceOf([&] { recon::ReadNUAGES(fileName, this->Monitor); }), fileName, "no such file");
  }
}

TEST_F(NUAGESParserInvalid, NamesLineAndWhatWasExpected)
{
  this->Expect("T 2\n", "line 1: expected 'S' and the number of sections");
  this->Expect("S two\n", "line 1: expected the number of sections, found 'two'");
  this->Expect("S -1\n", "line 1: expected the number of sections, found '-1'");
  this->Expect("S 1\n\nv 3 y 0 { 0 0 1 0 1 1 }",
    "line 3: expected 'z' and the height of the section, found 'y'");
  this->Expect(
    "S 1\nv 3 z 0\n{\n0 0\n1 zero\n1 1\n}\n", "line 5: expected y of a vertex, found 'zero'");
  this->Expect("S 1\nv 3 z 0\n{\n0 0\n1,5 0\n1 1\n}\n", "line 5: expected x of a vertex");
  this->Expect("S 1\nv 3 z 0\n{\n0 0\n1 0\n1\n}\n", "line 7: expected y of a vertex, found '}'");
  this->Expect(
    "S 1\nv 4 z 0\n{\n0 0\n1 0\n1 1\n}\n", "announces 4 vertices, but its contours have 3");
  this->Expect(
    "S 1\nv 2 z 0\n{\n0 0\n1 0\n1 1\n}\n", "announces 2 vertices, but its contours have 3");
  this->Expect("S 1\nv 3 z 0\n{\n0 0\n1 0\n1 1\n}\nv 0 z 1\n",
    "line 8: expected the end of the file after 1 sections, found 'v'");
}

TEST_F(NUAGESParserInvalid, NumbersThatAreNone)
{
  for (const char* number : { "nan", "inf", "-inf", "1e999", "0x10", "1.2.3", "--1", "+-1", "1e" })
  {
    this->Expect(
      std::string("S 1\nv 3 z 0\n{\n0 0\n1 0\n1 ") + number + "\n}\n", "expected y of a vertex");
    this->Expect(std::string("S 1\nv 3 z ") + number + "\n{\n0 0\n1 0\n1 1\n}\n",
      "expected the height of the section");
  }
}

TEST_F(NUAGESParserInvalid, HugeCountsAreRefusedBeforeAnythingIsAllocated)
{
  this->Expect("S 2000000000\nv 3 z 0\n", "more than the rest of the file can hold");
  this->Expect("S 99999999999999999999\n", "expected the number of sections");
  this->Expect("S 1\nv 2000000000 z 0\n{\n0 0\n}\n", "more than the rest of the file can hold");
}

TEST_F(NUAGESParserInvalid, BinaryOrMutated)
{
  for (unsigned int seed = 0; seed < 10; ++seed)
  {
    this->Expect(RandomBytes(4096, seed), "binary");
  }
  // One byte changed: the same contours can result (a digit for a digit), but nothing worse than a
  // sentence.
  std::mt19937 random(3);
  for (int i = 0; i < 500; ++i)
  {
    std::string bytes = Whole;
    bytes[random() % bytes.size()] = static_cast<char>(random() & 0xff);
    this->Sentence(bytes);
  }
}

TEST_F(NUAGESParserInvalid, AbortEndsTheReading)
{
  class Impatient : public recon::Monitor
  {
    bool AbortRequested() override { return true; }
  };
  Impatient monitor;
  const std::string fileName = this->Write("a.cnt", Whole);
  EXPECT_THROW(recon::ReadNUAGES(fileName, monitor), recon::Aborted);
}
