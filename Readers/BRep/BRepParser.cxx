// SPDX-License-Identifier: GPL-3.0-or-later
#include "BRep/BRepParser.h"

#include "Common/TextFile.h"
#include "Common/TextScanner.h"

#include <utility>

namespace recon
{
namespace
{
// The shortest text of each thing, for counts that no file of this size can honour.
constexpr std::size_t BytesOfVertex = 6;   // "0 0 0 "
constexpr std::size_t BytesOfEdge = 4;     // "0 1 "
constexpr std::size_t BytesOfFace = 12;    // "0(1)2(3)4(5)"
constexpr std::size_t BytesOfContour = 5;  // "(1) 0"
constexpr std::size_t BytesOfHalfEdge = 2; // "0 "
constexpr std::size_t BytesOfShell = 60;   // the keywords alone take more

/// Comments become blanks and parentheses words, so that blanks part all tokens; lines stay lines.
std::string Prepared(const std::string& text)
{
  std::string result;
  result.reserve(text.size() + text.size() / 4);
  bool inComment = false;
  for (const char c : text)
  {
    inComment = c != '\n' && (inComment || c == '#');
    if (inComment)
    {
      result += ' ';
    }
    else if (c == '(' || c == ')')
    {
      result += { ' ', c, ' ' };
    }
    else
    {
      result += c;
    }
  }
  return result;
}

class Parser
{
public:
  Parser(const std::string& fileName, Monitor& monitor)
    : Scanner(fileName, Prepared(ReadTextFile(fileName))),
      Progress(monitor)
  {
  }

  BRep Read()
  {
    BRep brep;
    const int sets = this->NextPositive("NUM_SHELL_SETS", "the number of shell sets", BytesOfShell);
    for (int i = 0; i < sets; ++i)
    {
      brep.ShellSets.push_back(this->ReadShellSet());
    }
    this->Scanner.ExpectEnd("after the last of the shell sets");
    return brep;
  }

private:
  BRepShellSet ReadShellSet()
  {
    this->Keyword("BEGIN_SHELL_SET");
    BRepShellSet set;
    const int shells = this->NextPositive("NUM_SHELLS", "the number of shells", BytesOfShell);
    for (int i = 0; i < shells; ++i)
    {
      set.Shells.push_back(this->ReadShell());
    }
    this->Keyword("END_SHELL_SET");
    return set;
  }

  BRepShell ReadShell()
  {
    this->Keyword("BEGIN_SHELL");
    const int line = this->Scanner.GetLine();
    ++this->ShellNumber;
    BRepShell shell;
    this->ReadVertices(shell);
    this->ReadEdges(shell);
    this->ReadFaces(shell);
    this->ReadContours(shell);
    this->Keyword("END_SHELL");
    const std::string defect = FindShellDefect(shell);
    if (!defect.empty())
    {
      throw Error("Cannot read " + this->Scanner.GetFileName() + ": in shell " +
        std::to_string(this->ShellNumber) + " (line " + std::to_string(line) + ") " + defect + ".");
    }
    return shell;
  }

  void ReadVertices(BRepShell& shell)
  {
    const int count = this->NextPositive("VERTICES", "the number of vertices", BytesOfVertex);
    shell.Vertices.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
    {
      this->Report(i);
      const double x = this->Scanner.NextNumber("x of a vertex");
      const double y = this->Scanner.NextNumber("y of a vertex");
      const double z = this->Scanner.NextNumber("z of a vertex");
      shell.Vertices.push_back({ x, y, z });
    }
  }

  void ReadEdges(BRepShell& shell)
  {
    const int count = this->NextPositive("EDGES", "the number of half-edges", BytesOfEdge);
    shell.Edges.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
    {
      this->Report(i);
      const int from = this->NextIndex("the first vertex of a half-edge");
      const int to = this->NextIndex("the second vertex of a half-edge");
      shell.Edges.push_back({ from, to });
    }
  }

  void ReadFaces(BRepShell& shell)
  {
    const int count = this->NextPositive("FACES", "the number of faces", BytesOfFace);
    if (shell.Edges.size() != 3 * static_cast<std::size_t>(count))
    {
      this->Scanner.Fail("the number of faces is " + std::to_string(count) + ", but there are " +
        std::to_string(shell.Edges.size()) + " half-edges, and it takes three a face.");
    }
    shell.Faces.reserve(static_cast<std::size_t>(count));
    shell.Partners.assign(shell.Edges.size(), -1);
    for (int f = 0; f < count; ++f)
    {
      this->Report(f);
      std::array<int, 3> face{};
      for (int& h : face)
      {
        h = this->NextIndex("a half-edge of a face");
        if (static_cast<std::size_t>(h) >= shell.Edges.size())
        {
          this->Scanner.Fail("face " + std::to_string(f) + " names half-edge " + std::to_string(h) +
            ", but the shell has " + std::to_string(shell.Edges.size()) + ", counted from 0.");
        }
        this->Scanner.Expect("(", "'(' and the partner of the half-edge");
        shell.Partners[h] = this->NextIndex("the partner of the half-edge");
        this->Scanner.Expect(")", "')' after the partner of the half-edge");
      }
      shell.Faces.push_back(face);
    }
  }

  void ReadContours(BRepShell& shell)
  {
    this->Keyword("CONTOURS");
    const int count = this->Count("the number of contours", BytesOfContour);
    for (int c = 0; c < count; ++c)
    {
      this->Scanner.Expect("(", "'(' and the number of half-edges of a contour");
      const int size = this->Count("the number of half-edges of a contour", BytesOfHalfEdge);
      if (size == 0)
      {
        this->Scanner.Fail("contour " + std::to_string(c) + " has no half-edges.");
      }
      this->Scanner.Expect(")", "')' after the number of half-edges of a contour");
      std::vector<int> contour;
      for (int i = 0; i < size; ++i)
      {
        this->Report(i);
        contour.push_back(this->NextIndex("a half-edge of a contour"));
      }
      shell.Contours.push_back(std::move(contour));
    }
  }

  void Keyword(const char* word)
  {
    const std::string expected = std::string("the keyword ") + word;
    this->Scanner.Expect(word, expected.c_str());
  }

  /// A keyword and how many things follow: at least one.
  int NextPositive(const char* keyword, const char* expected, std::size_t bytesEach)
  {
    this->Keyword(keyword);
    const int count = this->Count(expected, bytesEach);
    if (count == 0)
    {
      this->Scanner.Fail(std::string(expected) + " is 0, but there must be at least one.");
    }
    return count;
  }

  int Count(const char* expected, std::size_t bytesEach)
  {
    const int count = this->NextIndex(expected);
    this->Scanner.CheckCount(expected, count, bytesEach);
    return count;
  }

  /// pos_integer of the grammar: digits with a plus at most.
  int NextIndex(const char* expected)
  {
    const std::string_view token = this->Scanner.Next(expected);
    int value = 0;
    if (token.front() == '-' || !ParseInteger(token, value))
    {
      this->Scanner.FailExpected(expected, token);
    }
    return value;
  }

  void Report(int done)
  {
    if (done % 1024 == 0)
    {
      this->Progress.Update(this->Scanner.GetFraction(), "reading shells");
    }
  }

  TextScanner Scanner;
  Monitor& Progress;
  int ShellNumber = 0; ///< counted from 1, for messages
};
}

bool IsBRep(const std::string& fileName)
{
  // Comments may come first; a file that has 64 kB of them is not told by this.
  const std::string start = Prepared(ReadStart(fileName, 65536));
  const std::string keyword = "NUM_SHELL_SETS";
  const std::size_t word = start.find_first_not_of(" \t\r\n");
  if (word == std::string::npos || start.compare(word, keyword.size(), keyword) != 0)
  {
    return false;
  }
  const std::size_t end = word + keyword.size();
  return end == start.size() || std::string(" \t\r\n").find(start[end]) != std::string::npos;
}

BRep ReadBRep(const std::string& fileName, Monitor& monitor)
{
  return Parser(fileName, monitor).Read();
}
}
