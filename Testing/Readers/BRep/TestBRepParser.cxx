// SPDX-License-Identifier: GPL-3.0-or-later
// The grammar of the thesis's appendix: its example, all forms of its tokens, and files that break
// it.
#include "BRep/BRepFormatter.h"
#include "BRep/BRepParser.h"
#include "Common/TextFile.h"
#include "TestPaths.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

using namespace recon;

namespace
{
std::string Example()
{
  return recon::testing::OwnPath("Data/example.brep");
}

std::string Temporary()
{
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  return ::testing::TempDir() + "TestBRepParser" + test->name() + ".brep";
}

BRep ReadText(const std::string& text)
{
  Monitor monitor;
  WriteTextFile(Temporary(), text);
  return ReadBRep(Temporary(), monitor);
}

/// The sentence that reading the text ends in; empty where it is read.
std::string FailureOf(const std::string& text)
{
  try
  {
    ReadText(text);
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return {};
}

/// Words of a file without its comments, parentheses being words.
std::vector<std::string> Tokens(const std::string& text)
{
  std::string plain;
  bool inComment = false;
  for (const char c : text)
  {
    inComment = c != '\n' && (inComment || c == '#');
    plain += inComment       ? std::string(" ")
      : c == '(' || c == ')' ? std::string{ ' ', c, ' ' }
                             : std::string(1, c);
  }
  std::istringstream stream(plain);
  std::vector<std::string> tokens;
  for (std::string token; stream >> token;)
  {
    tokens.push_back(token);
  }
  return tokens;
}

/// A token a line, so that the line of an error is the number of its token.
std::string Joined(const std::vector<std::string>& tokens)
{
  std::string text;
  for (const std::string& token : tokens)
  {
    text += token + '\n';
  }
  return text;
}

const std::string Tetrahedron = "NUM_SHELL_SETS 1 BEGIN_SHELL_SET NUM_SHELLS 1 BEGIN_SHELL\n"
                                "VERTICES 4 0 0 0 1 0 0 0 1 0 0 0 1\n"
                                "EDGES 12 0 2 2 1 1 0 0 1 1 3 3 0 1 2 2 3 3 1 2 0 0 3 3 2\n"
                                "FACES 4 0(9) 1(6) 2(3) 3(2) 4(8) 5(10) 6(1) 7(11) 8(4) 9(0) "
                                "10(5) 11(7)\nCONTOURS 1 (3) 0 1 2\nEND_SHELL END_SHELL_SET\n";

std::string WithFirstNumber(const std::string& number)
{
  std::string text = Tetrahedron;
  return text.replace(text.find("VERTICES 4 0"), 12, "VERTICES 4 " + number);
}

bool SameBits(double a, double b)
{
  return std::memcmp(&a, &b, sizeof(double)) == 0;
}

void ExpectSame(const BRep& a, const BRep& b)
{
  ASSERT_EQ(a.ShellSets.size(), b.ShellSets.size());
  for (std::size_t s = 0; s < a.ShellSets.size(); ++s)
  {
    ASSERT_EQ(a.ShellSets[s].Shells.size(), b.ShellSets[s].Shells.size());
    for (std::size_t i = 0; i < a.ShellSets[s].Shells.size(); ++i)
    {
      const BRepShell& p = a.ShellSets[s].Shells[i];
      const BRepShell& q = b.ShellSets[s].Shells[i];
      ASSERT_EQ(p.Vertices.size(), q.Vertices.size());
      for (std::size_t v = 0; v < p.Vertices.size(); ++v)
      {
        for (int c = 0; c < 3; ++c)
        {
          EXPECT_TRUE(SameBits(p.Vertices[v][c], q.Vertices[v][c])) << "vertex " << v;
        }
      }
      EXPECT_EQ(p.Edges, q.Edges);
      EXPECT_EQ(p.Faces, q.Faces);
      EXPECT_EQ(p.Partners, q.Partners);
      EXPECT_EQ(p.Contours, q.Contours);
    }
  }
}
}

TEST(BRepParser, TheExampleOfTheAppendixIsRead)
{
  Monitor monitor;
  EXPECT_TRUE(IsBRep(Example()));
  const BRep brep = ReadBRep(Example(), monitor);
  ASSERT_EQ(brep.ShellSets.size(), 1u);
  ASSERT_EQ(brep.ShellSets[0].Shells.size(), 2u);
  const BRepShell& box = brep.ShellSets[0].Shells[0];
  const BRepShell& tube = brep.ShellSets[0].Shells[1];
  EXPECT_EQ(box.Vertices.size(), 8u);
  EXPECT_EQ(box.Faces.size(), 12u);
  EXPECT_EQ(box.Vertices[0], (Point3{ 2.404294, -2.154735, 10 }));
  EXPECT_EQ(box.Vertices[1], (Point3{ 2.404294, -2.154735, 0 })) << "printed .2404294e+1";
  EXPECT_TRUE(box.Contours.empty());
  EXPECT_EQ(tube.Vertices.size(), 18u);
  EXPECT_EQ(tube.Faces.size(), 20u);
  ASSERT_EQ(tube.Contours.size(), 2u);
  EXPECT_EQ(tube.Contours[0], (std::vector<int>{ 0, 6, 15, 18, 25, 31, 35, 41, 48 }));
  EXPECT_EQ(tube.Contours[1], (std::vector<int>{ 43, 36, 27, 23, 13, 59, 54 }));
}

TEST(BRepParser, PartnersWorkedOutFromTheTrianglesAreThePrintedOnes)
{
  Monitor monitor;
  const BRep printed = ReadBRep(Example(), monitor);
  ShelledMesh mesh = MakeMesh(printed);
  std::vector<SpaceLoop> contours;
  for (const auto& contour : mesh.Contours)
  {
    contours.emplace_back();
    for (const int point : contour)
    {
      contours.back().push_back(mesh.Mesh.Points[point]);
    }
  }
  std::vector<int> missing;
  ExpectSame(MakeBRep(mesh.Mesh, {}, contours, missing, monitor), printed);
  EXPECT_TRUE(missing.empty());
  // Its contours are its borders, so that they come back also where nobody names them.
  const BRep unnamed = MakeBRep(mesh.Mesh, {}, {}, missing, monitor);
  EXPECT_EQ(unnamed.ShellSets[0].Shells[1].Partners, printed.ShellSets[0].Shells[1].Partners);
  EXPECT_EQ(unnamed.ShellSets[0].Shells[1].Contours.size(), 2u);
}

TEST(BRepParser, TheExampleIsWrittenBackEqual)
{
  Monitor monitor;
  const BRep brep = ReadBRep(Example(), monitor);
  WriteBRep(Temporary(), brep, monitor);
  ExpectSame(ReadBRep(Temporary(), monitor), brep);
  const std::vector<std::string> printed = Tokens(ReadTextFile(Example()));
  const std::vector<std::string> written = Tokens(ReadTextFile(Temporary()));
  ASSERT_EQ(written.size(), printed.size());
  for (std::size_t i = 0; i < printed.size(); ++i)
  {
    const bool isNumber = printed[i].find_first_not_of("0123456789+-.e") == std::string::npos;
    const bool equal =
      isNumber ? std::stod(written[i]) == std::stod(printed[i]) : written[i] == printed[i];
    EXPECT_TRUE(equal) << "token " << i << ": " << written[i] << " for " << printed[i];
  }
}

TEST(BRepParser, EveryDoubleComesBackToTheLastBit)
{
  Monitor monitor;
  BRep brep = ReadText(Tetrahedron);
  std::vector<double> numbers{ 0.1, -0.0, 1.0 / 3.0, 5e-324, -2.2250738585072011e-308,
    std::numeric_limits<double>::max(), std::numeric_limits<double>::min(), 9007199254740993.0,
    1e23, std::nextafter(1.0, 2.0), -123456.78901234567 };
  unsigned long long state = 1;
  for (int i = 0; i < 3000; ++i)
  {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    double value = 0;
    const unsigned long long bits = state ^ (state >> 29);
    std::memcpy(&value, &bits, sizeof(double));
    if (std::isfinite(value))
    {
      numbers.push_back(value);
    }
  }
  std::vector<Point3>& vertices = brep.ShellSets[0].Shells[0].Vertices;
  while (numbers.size() % 3 != 0)
  {
    numbers.pop_back();
  }
  for (std::size_t i = 0; i < numbers.size(); i += 3)
  {
    vertices.push_back({ numbers[i], numbers[i + 1], numbers[i + 2] });
  }
  WriteBRep(Temporary(), brep, monitor);
  ExpectSame(ReadBRep(Temporary(), monitor), brep);
}

TEST(BRepParser, AllFormsOfNumbersAreRead)
{
  const std::vector<std::pair<std::string, double>> forms{ { "7", 7 }, { "+7", 7 }, { "-7", -7 },
    { "007", 7 }, { "7.", 7 }, { "7.25", 7.25 }, { ".25", 0.25 }, { "+.25", 0.25 },
    { "-.25", -0.25 }, { "25e-2", 0.25 }, { "25E-2", 0.25 }, { ".25e1", 2.5 }, { "+2.5e+1", 25 },
    { "2.5e01", 25 }, { "-0", -0.0 } };
  for (const auto& [text, value] : forms)
  {
    const BRep brep = ReadText(WithFirstNumber(text));
    EXPECT_TRUE(SameBits(brep.ShellSets[0].Shells[0].Vertices[0][0], value)) << text;
  }
}

TEST(BRepParser, CommentsAndBlanksMayBeAnywhere)
{
  const BRep plain = ReadText(Tetrahedron);
  std::string commented = "# before all ( )\r\n\t\n#\n";
  for (const std::string& token : Tokens(Tetrahedron))
  {
    commented += token + "# after '" + token + "' 1 2 END_SHELL\r\n";
  }
  ExpectSame(ReadText(commented + "# no line end"), plain);
  std::string spread = Tetrahedron;
  for (std::size_t at = 0; (at = spread.find('(', at)) != std::string::npos; at += 3)
  {
    spread.replace(at, 1, " (\t");
  }
  ExpectSame(ReadText(spread), plain);
  ExpectSame(ReadText(WithFirstNumber("+00")), plain);
}

TEST(BRepParser, OtherFormatsAreTold)
{
  for (const char* text :
    { "", "solid x\n", "NUM_SHELL_SETSS 1", "# NUM_SHELL_SETS 1\n", "S 2\nv" })
  {
    WriteTextFile(Temporary(), text);
    EXPECT_FALSE(IsBRep(Temporary())) << text;
  }
  WriteTextFile(Temporary(), "# a\n\n #b\n\tNUM_SHELL_SETS# c\n1");
  EXPECT_TRUE(IsBRep(Temporary()));
  EXPECT_FALSE(IsBRep(Temporary() + ".absent"));
  EXPECT_FALSE(IsBRep(::testing::TempDir()));
}

TEST(BRepParserInvalid, EveryMutationOfTheExampleIsASentence)
{
  // Take out, double, replace or cut off at every token; and make every number of the topology
  // wrong.
  const std::vector<std::string> tokens = Tokens(ReadTextFile(Example()));
  ASSERT_EQ(FailureOf(Joined(tokens)), "");
  int mutated = 0;
  const auto expectSentence = [&](const std::vector<std::string>& mutation, std::size_t token)
  {
    const std::string sentence = FailureOf(Joined(mutation));
    ++mutated;
    EXPECT_EQ(sentence.rfind("Cannot read ", 0), 0u)
      << "mutation " << mutated << " at token " << token << ": '" << sentence << "'";
    EXPECT_NE(sentence.find("line "), std::string::npos) << sentence;
    EXPECT_EQ(sentence.back(), '.') << sentence;
  };
  bool inVertices = false;
  for (std::size_t i = 0; i < tokens.size(); ++i)
  {
    inVertices = tokens[i] == "VERTICES" || (inVertices && tokens[i] != "EDGES");
    std::vector<std::string> mutation = tokens;
    mutation.erase(mutation.begin() + static_cast<std::ptrdiff_t>(i));
    expectSentence(mutation, i);
    mutation = tokens;
    mutation.insert(mutation.begin() + static_cast<std::ptrdiff_t>(i), tokens[i]);
    expectSentence(mutation, i);
    const std::array<const char*, 8> words{ "junk", "-", "1e999", "nan", "(", ")", "END_SHELL",
      "\"" };
    for (const char* other : { words[i % 8], words[(i + 3) % 8] })
    {
      if (tokens[i] != other)
      {
        mutation = tokens;
        mutation[i] = other;
        expectSentence(mutation, i);
      }
    }
    if (i > 0) // nothing at all is another test's
    {
      expectSentence({ tokens.begin(), tokens.begin() + static_cast<std::ptrdiff_t>(i) }, i);
    }
    const bool isIndex =
      !inVertices && tokens[i].find_first_not_of("0123456789") == std::string::npos;
    if (isIndex)
    {
      for (const char* other : { "-1", "1.5", "2000000000", "99999999999999999999" })
      {
        mutation[i] = other;
        expectSentence(mutation, i);
      }
      mutation = tokens;
      mutation[i] = std::to_string(std::stoi(tokens[i]) + 1);
      expectSentence(mutation, i);
    }
  }
  EXPECT_GT(mutated, 100);
}

TEST(BRepParserInvalid, NoByteCrashesIt)
{
  // What a wrong byte does is open: a digit of a coordinate may become another. It must not crash.
  const std::string text = ReadTextFile(Example());
  unsigned state = 12345;
  int refused = 0;
  for (int i = 0; i < 1500; ++i)
  {
    std::string mutation = text;
    for (int k = 0; k < 1 + i % 3; ++k)
    {
      state = state * 1664525u + 1013904223u;
      mutation[(state >> 8) % text.size()] = static_cast<char>(state >> 24);
    }
    const std::string sentence = FailureOf(mutation);
    refused += !sentence.empty();
    EXPECT_TRUE(sentence.empty() || sentence.rfind("Cannot read ", 0) == 0) << sentence;
  }
  EXPECT_GT(refused, 500);
}

TEST(BRepParserInvalid, SentencesNameLineAndToken)
{
  const auto expectIn = [](const std::string& text, const std::vector<std::string>& parts)
  {
    const std::string sentence = FailureOf(text);
    for (const std::string& part : parts)
    {
      EXPECT_NE(sentence.find(part), std::string::npos) << "'" << part << "' in: " << sentence;
    }
  };
  expectIn(WithFirstNumber("zero"), { "line 2", "'zero'", "x of a vertex" });
  expectIn(WithFirstNumber("e5"), { "line 2", "'e5'" });
  std::string text = Tetrahedron;
  expectIn(text.replace(text.find("EDGES 12"), 8, "EDGES 99"), { "line 3", "99" });
  text = Tetrahedron;
  expectIn(text.replace(text.find("CONTOURS 1"), 10, "CONTOURS 2000000000"),
    { "line 5", "2000000000", "more than" });
  text = Tetrahedron;
  expectIn(
    text.replace(text.find("0(9)"), 4, "0(8)"), { "line 1", "shell 1", "half-edge 0 (0-2)" });
  expectIn(Tetrahedron + "NUM_SHELL_SETS 1", { "line 7", "end of the file" });
  expectIn("", { "empty" });
  expectIn(std::string("NUM_SHELL_SETS \0 1", 18), { "line 1", "binary" });
}

TEST(BRepParserInvalid, NothingIsWrittenThatCannotBeReadBack)
{
  Monitor monitor;
  const auto failureOf = [&](const BRep& brep, const std::string& fileName)
  {
    try
    {
      WriteBRep(fileName, brep, monitor);
    }
    catch (const Error& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string fileName = Temporary();
  const BRep sound = ReadText(Tetrahedron);
  std::remove(fileName.c_str());
  BRep broken = sound;
  broken.ShellSets[0].Shells[0].Partners[0] = 5;
  EXPECT_NE(failureOf(broken, fileName).find("half-edge 0"), std::string::npos);
  broken = sound;
  broken.ShellSets[0].Shells[0].Vertices[2][1] = std::nan("");
  EXPECT_NE(failureOf(broken, fileName).find("vertex 2"), std::string::npos);
  EXPECT_NE(failureOf(BRep(), fileName), "");
  EXPECT_NE(failureOf(BRep{ { BRepShellSet() } }, fileName), "");
  EXPECT_FALSE(IsBRep(fileName)) << "no file is left behind";
  EXPECT_NE(
    failureOf(sound, "/no such folder/x.brep").find("there is no folder"), std::string::npos);
}
