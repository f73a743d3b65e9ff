// SPDX-License-Identifier: GPL-3.0-or-later
#include "NUAGES/NUAGESParser.h"

#include "Common/TextScanner.h"

#include <sstream>

namespace recon
{
namespace
{
// The shortest section is "v 0 z 0 " and the shortest vertex "0 0 ".
constexpr std::size_t BytesPerSection = 8;
constexpr std::size_t BytesPerVertex = 4;

bool IsSectionsKey(std::string_view token)
{
  return token == "S" || token == "s";
}

class Parser
{
public:
  Parser(const std::string& fileName, Monitor& monitor) : Scanner(fileName), Progress(monitor) {}

  ContourFile Read()
  {
    const char* const header = "'S' and the number of sections, as a NUAGES file begins";
    const std::string_view key = this->Scanner.Next(header);
    if (!IsSectionsKey(key))
    {
      this->Scanner.FailExpected(header, key);
    }
    const int sections = this->Scanner.NextCount("the number of sections", BytesPerSection);
    for (this->Section = 1; this->Section <= sections; ++this->Section)
    {
      this->ReadSection();
      this->Progress.Update(this->Scanner.GetFraction(), "reading sections");
    }
    this->Scanner.ExpectEnd("after " + std::to_string(sections) + " sections");
    return std::move(this->Result);
  }

private:
  void ReadSection()
  {
    this->Scanner.Expect("v", "'v' and the number of vertices of the next section");
    const int vertices =
      this->Scanner.NextCount("the number of vertices of the section", BytesPerVertex);
    const int line = this->Scanner.GetLine();
    this->Scanner.Expect("z", "'z' and the height of the section");
    const double z = this->Scanner.NextNumber("the height of the section");
    const std::size_t before = this->Result.Soup.Points.size();
    for (int contour = 1; this->Scanner.Peek() == "{"; ++contour)
    {
      this->ReadContour(z, contour);
    }
    const std::size_t found = this->Result.Soup.Points.size() - before;
    if (found != static_cast<std::size_t>(vertices))
    {
      this->Scanner.Fail("section " + std::to_string(this->Section) + " (line " +
        std::to_string(line) + ") announces " + std::to_string(vertices) +
        " vertices, but its contours have " + std::to_string(found) + ".");
    }
  }

  void ReadContour(double z, int contour)
  {
    this->Scanner.Expect("{", "'{' and a contour");
    LoopSoup& soup = this->Result.Soup;
    LoopSoup::Chain chain;
    while (this->Scanner.Peek() != "}")
    {
      const double x = this->Scanner.NextNumber("x of a vertex, or '}' at the end of the contour");
      const double y = this->Scanner.NextNumber("y of a vertex");
      chain.Points.push_back(static_cast<int>(soup.Points.size()));
      soup.Points.push_back({ x, y, z });
    }
    this->Scanner.Expect("}", "'}' at the end of the contour");
    if (chain.Points.empty())
    {
      this->Result.Report.push_back("Section " + std::to_string(this->Section) + ", contour " +
        std::to_string(contour) + ": left out, it has no vertices.");
      return;
    }
    chain.Closed = true;
    chain.Source = static_cast<int>(soup.Chains.size());
    soup.Chains.push_back(std::move(chain));
  }

  TextScanner Scanner;
  Monitor& Progress;
  ContourFile Result;
  int Section = 0;
};
}

bool IsNUAGES(const std::string& fileName)
{
  std::istringstream start(ReadStart(fileName, 256));
  std::string key, count, vertices;
  start >> key >> count >> vertices;
  int sections = 0;
  return IsSectionsKey(key) && ParseInteger(count, sections) && sections >= 0 &&
    (vertices == "v" || (vertices.empty() && sections == 0));
}

ContourFile ReadNUAGES(const std::string& fileName, Monitor& monitor)
{
  return Parser(fileName, monitor).Read();
}
}
