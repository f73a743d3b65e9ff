// SPDX-License-Identifier: GPL-3.0-or-later
#include "Table/ContourTableParser.h"

#include "Base/Text.h"
#include "Common/TextFile.h"
#include "Common/TextScanner.h"
#include "Table/TableColumns.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

namespace recon
{
namespace
{
constexpr std::size_t StartSize = 4096;
constexpr std::size_t RowsAnUpdate = 1 << 14;
constexpr std::size_t FewestOfContour = 3; // points

/// Goes through the lines of a text, whatever ends them.
class Lines
{
public:
  explicit Lines(std::string_view text) : Text(text)
  {
    if (this->Text.substr(0, 3) == "\xEF\xBB\xBF")
    {
      this->Text.remove_prefix(3);
    }
  }

  bool Next(std::string_view& line)
  {
    if (this->At >= this->Text.size())
    {
      return false;
    }
    const std::size_t end = std::min(this->Text.find('\n', this->At), this->Text.size());
    line = this->Text.substr(this->At, end - this->At);
    this->At = end + 1;
    ++this->Number;
    return true;
  }

  int GetNumber() const { return this->Number; }
  double GetFraction() const
  {
    return static_cast<double>(this->At) / static_cast<double>(this->Text.size() + 1);
  }

private:
  std::string_view Text;
  std::size_t At = 0;
  int Number = 0;
};

bool IsBlank(std::string_view line)
{
  return line.find_first_not_of(" \t\r,;") == std::string_view::npos;
}

bool IsComment(std::string_view line)
{
  const std::size_t first = line.find_first_not_of(" \t");
  return first != std::string_view::npos && line[first] == '#';
}

/// Decimal commas where commas do not separate columns.
bool ParseCell(std::string word, char separator, double& value)
{
  if (separator != ',')
  {
    std::replace(word.begin(), word.end(), ',', '.');
  }
  return ParseNumber(word, value);
}

/// What a contour is known by, and its points.
struct Run
{
  std::string Object;
  std::string Slice;
  std::string Contour;
  std::vector<Point3> Points;
};

/// Points of equal z that follow each other, where each such piece is a contour; or one piece.
std::vector<std::vector<Point3>> PiecesByHeight(const std::vector<Point3>& points)
{
  std::vector<std::vector<Point3>> pieces;
  for (const Point3& point : points)
  {
    if (pieces.empty() || pieces.back().back()[2] != point[2])
    {
      pieces.emplace_back();
    }
    pieces.back().push_back(point);
  }
  const bool areContours = std::all_of(pieces.begin(), pieces.end(),
    [](const auto& piece) { return piece.size() >= FewestOfContour; });
  return areContours ? pieces : std::vector<std::vector<Point3>>{ points };
}

class Parser
{
public:
  Parser(const std::string& fileName, const SliceStack& stack, Monitor& monitor)
    : FileName(fileName),
      Stack(stack),
      Progress(monitor)
  {
  }

  TracedFile Read(const std::string& text)
  {
    Lines lines(text);
    std::string_view line;
    std::size_t rows = 0;
    while (lines.Next(line))
    {
      this->Line = lines.GetNumber();
      this->ReadLine(line);
      if (++rows % RowsAnUpdate == 0)
      {
        this->Progress.Update(lines.GetFraction(), "reading rows");
      }
    }
    this->FinishRun();
    if (this->Split > 0)
    {
      this->Traces.Say(Counted(this->Split, "contour") +
        " of one number at several z: taken as a contour at each z.");
    }
    if (this->Stack.PixelSize == 1)
    {
      this->Traces.SetLengthUnit(this->Columns.LengthUnit);
    }
    return this->Traces.Take(this->FileName);
  }

private:
  void ReadLine(std::string_view line)
  {
    if (IsComment(line))
    {
      return;
    }
    if (IsBlank(line))
    {
      this->IsNew = this->Columns.Contour < 0;
      return;
    }
    if (!this->Columns.HasPlace())
    {
      this->Separator = SeparatorOf(line);
      if (this->ReadNames(SplitRow(line, this->Separator)))
      {
        return;
      }
    }
    this->ReadRow(SplitRow(line, this->Separator));
  }

  /// Returns whether the line was names, and not a row already.
  bool ReadNames(const std::vector<std::string>& words)
  {
    this->Width = words.size();
    double value = 0;
    const bool isRow = std::all_of(words.begin(), words.end(),
      [&](const std::string& word) { return ParseCell(word, this->Separator, value); });
    this->Columns = isRow ? TableColumns::Counted(words.size()) : TableColumns::Named(words);
    if (!this->Columns.HasPlace())
    {
      this->Fail("expected names of columns, x and y among them, or rows of numbers.");
    }
    if (this->Columns.Z < 0 && this->Columns.Slice < 0)
    {
      this->Fail("there is neither a column z nor one for the slice (slice, section, plane).");
    }
    return !isRow;
  }

  void ReadRow(const std::vector<std::string>& words)
  {
    if (words.size() < this->Width)
    {
      this->Fail("expected " + std::to_string(this->Width) + " columns, found " +
        std::to_string(words.size()) + ".");
    }
    const std::string object = Cell(words, this->Columns.Object);
    const std::string slice = Cell(words, this->Columns.Slice);
    const std::string contour = Cell(words, this->Columns.Contour);
    const Point3 point{ this->Stack.PixelSize * this->Number(words, this->Columns.X, "x"),
      this->Stack.PixelSize * this->Number(words, this->Columns.Y, "y"), this->Height(words) };
    const bool hasChanged = object != this->Current.Object || slice != this->Current.Slice ||
      contour != this->Current.Contour;
    if (hasChanged || this->IsNew || this->ChangesHeight(point))
    {
      this->FinishRun();
      this->Current = { object, slice, contour, {} };
    }
    this->AddPoint(point);
  }

  bool ChangesHeight(const Point3& point) const
  {
    return this->Columns.Contour < 0 && !this->Current.Points.empty() &&
      this->Current.Points.back()[2] != point[2];
  }

  void AddPoint(const Point3& point)
  {
    std::vector<Point3>& points = this->Current.Points;
    this->IsNew =
      this->Columns.Contour < 0 && points.size() >= FewestOfContour && point == points.front();
    points.push_back(point);
  }

  static std::string Cell(const std::vector<std::string>& words, int column)
  {
    return column < 0 ? std::string() : words[static_cast<std::size_t>(column)];
  }

  double Number(const std::vector<std::string>& words, int column, const char* name) const
  {
    const std::string word = Cell(words, column);
    double value = 0;
    if (!ParseCell(word, this->Separator, value))
    {
      this->Fail("expected a number for " + std::string(name) + ", found " + Quoted(word) + ".");
    }
    return value;
  }

  double Height(const std::vector<std::string>& words) const
  {
    return this->Columns.Z >= 0
      ? this->Number(words, this->Columns.Z, "z")
      : this->Stack.Spacing * this->Number(words, this->Columns.Slice, "the slice");
  }

  void FinishRun()
  {
    this->IsNew = false;
    if (this->Current.Points.empty())
    {
      return;
    }
    const std::string name = this->Columns.Object < 0 ? Stem(this->FileName) : this->Current.Object;
    TracedObject& object = this->Traces.Named(name);
    const auto pieces = PiecesByHeight(this->Current.Points);
    this->Split += pieces.size() > 1;
    for (const std::vector<Point3>& piece : pieces)
    {
      int slice = 0;
      const bool isNumbered = ParseInteger(this->Current.Slice, slice);
      this->Traces.Add(object, piece, true, isNumbered ? slice : 0, this->Current.Contour);
    }
    this->Current.Points.clear();
  }

  static std::string Stem(const std::string& fileName)
  {
    return std::filesystem::path(fileName).stem().string();
  }

  [[noreturn]] void Fail(const std::string& sentence) const
  {
    throw Error(
      "Cannot read " + this->FileName + ", line " + std::to_string(this->Line) + ": " + sentence);
  }

  std::string FileName;
  SliceStack Stack;
  Monitor& Progress;
  TraceCollector Traces;
  TableColumns Columns;
  char Separator = ',';
  std::size_t Width = 0;
  Run Current;
  bool IsNew = false; // the next row begins a contour
  std::size_t Split = 0;
  int Line = 0;
};
}

bool IsContourTable(const std::string& fileName)
{
  const std::string start = ReadStart(fileName, StartSize);
  Lines lines(start);
  std::string_view line;
  while (lines.Next(line))
  {
    if (!IsBlank(line) && !IsComment(line))
    {
      const TableColumns columns = TableColumns::Named(SplitRow(line, SeparatorOf(line)));
      return columns.HasPlace() && (columns.Slice >= 0 || columns.Contour >= 0);
    }
  }
  return false;
}

TracedFile ReadContourTable(const std::string& fileName, const SliceStack& stack, Monitor& monitor)
{
  const std::string text = ReadTextFile(fileName);
  if (text.find('\0') != std::string::npos)
  {
    throw Error("Cannot read " + fileName + ": this is a binary file, not a text file.");
  }
  return Parser(fileName, stack, monitor).Read(text);
}
}
