// SPDX-License-Identifier: GPL-3.0-or-later
#include "SVG/SVGParser.h"

#include "Base/Text.h"
#include "Common/TextFile.h"
#include "Common/TextScanner.h"
#include "Common/XMLText.h"
#include "SVG/SVGPath.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

namespace recon
{
namespace
{
constexpr std::size_t StartSize = 4096;
constexpr std::size_t DeepestNesting = 1000; // of groups; a bound for the stack of transforms

/// Millimetres of a length's unit; 0 for any other.
double Millimetres(const std::string& unit)
{
  static const std::vector<std::pair<std::string, double>> units{ { "mm", 1 }, { "cm", 10 },
    { "in", 25.4 }, { "pt", 25.4 / 72 }, { "pc", 25.4 / 6 } };
  const auto found = std::find_if(
    units.begin(), units.end(), [&](const auto& known) { return known.first == unit; });
  return found == units.end() ? 0 : found->second;
}

double NumberOf(const XMLElement& element, const char* name, double otherwise = 0)
{
  const std::vector<double> numbers = ParseNumbers(element.Get(name));
  return numbers.empty() ? otherwise : numbers.front();
}

/// What one of the shapes draws; nothing for other elements.
std::vector<SVGLine> LinesOf(const XMLElement& element, bool& isWhole)
{
  isWhole = true;
  const auto number = [&element](const char* name) { return NumberOf(element, name); };
  if (element.Name == "path")
  {
    return ParsePath(element.Get("d"), isWhole);
  }
  if (element.Name == "polygon" || element.Name == "polyline")
  {
    const std::vector<double> numbers = ParseNumbers(element.Get("points"));
    SVGLine line;
    line.Closed = element.Name == "polygon";
    isWhole = numbers.size() % 2 == 0;
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
    {
      line.Points.push_back({ numbers[i], numbers[i + 1] });
    }
    return { line };
  }
  if (element.Name == "rect")
  {
    const double x = number("x");
    const double y = number("y");
    const double width = number("width");
    const double height = number("height");
    return { { { { x, y }, { x + width, y }, { x + width, y + height }, { x, y + height } },
      true } };
  }
  if (element.Name == "circle")
  {
    return { EllipseOutline({ number("cx"), number("cy") }, number("r"), number("r")) };
  }
  if (element.Name == "ellipse")
  {
    return { EllipseOutline({ number("cx"), number("cy") }, number("rx"), number("ry")) };
  }
  if (element.Name == "line")
  {
    return { { { { number("x1"), number("y1") }, { number("x2"), number("y2") } }, false } };
  }
  return {};
}

struct DrawnLine
{
  std::string Object; // empty: the one without a label
  int Layer = 0;      // from 1; 0: in none
  SVGLine Line;
};

/// One drawing.
class Drawing : public XMLHandler
{
public:
  explicit Drawing(std::string fileName) : FileName(std::move(fileName)) {}

  void Begin(const XMLElement& element) override
  {
    const State outer = this->States.empty() ? State{} : this->States.back();
    if (this->States.empty() && element.Name != "svg")
    {
      this->Fail(element, "it is no drawing: its first element is " + Quoted(element.Name) + ".");
    }
    if (this->States.size() > DeepestNesting)
    {
      this->Fail(
        element, "groups are nested more than " + std::to_string(DeepestNesting) + " deep.");
    }
    this->States.push_back(this->Inner(outer, element));
    if (this->States.size() == 1)
    {
      this->ReadSize(element);
    }
    if (this->States.back().IsDrawn)
    {
      this->Draw(element);
    }
  }

  void End(const std::string&) override { this->States.pop_back(); }

  std::vector<DrawnLine> Lines;
  double Scale = 1; // to millimetres, where IsMillimetres
  bool IsMillimetres = false;
  int Layers = 0;
  std::size_t NotRead = 0;
  std::size_t Broken = 0;
  std::size_t Hidden = 0;

private:
  struct State
  {
    SVGMatrix Matrix = SVGIdentity;
    bool IsDrawn = true;
    std::string Label;
    int Layer = 0;
  };

  State Inner(const State& outer, const XMLElement& element)
  {
    static const std::set<std::string> notDrawn{ "defs", "clipPath", "mask", "marker", "pattern",
      "symbol", "linearGradient", "radialGradient", "metadata", "namedview", "style", "title" };
    State inner = outer;
    SVGMatrix matrix{};
    if (!ParseTransform(element.Get("transform"), matrix))
    {
      this->Fail(
        element, "transform " + Quoted(element.Get("transform")) + " is none that SVG knows.");
    }
    inner.Matrix = Compose(outer.Matrix, matrix);
    const bool isHidden = IsHidden(element);
    this->Hidden += isHidden && outer.IsDrawn;
    inner.IsDrawn = outer.IsDrawn && !isHidden && notDrawn.count(element.Name) == 0;
    const std::string label = element.Get("label");
    if (element.Get("groupmode") == "layer")
    {
      inner.Layer = ++this->Layers;
    }
    else if (!label.empty())
    {
      inner.Label = label;
    }
    return inner;
  }

  static bool IsHidden(const XMLElement& element)
  {
    std::string style = element.Get("style");
    style.erase(std::remove(style.begin(), style.end(), ' '), style.end());
    return element.Get("display") == "none" || style.find("display:none") != std::string::npos;
  }

  void ReadSize(const XMLElement& element)
  {
    const std::string width = element.Get("width");
    const std::size_t end = width.find_last_of("0123456789.");
    const std::vector<double> box = ParseNumbers(element.Get("viewBox"));
    const double unit = end == std::string::npos ? 0 : Millimetres(width.substr(end + 1));
    const double length = NumberOf(element, "width");
    if (unit > 0 && length > 0 && box.size() == 4 && box[2] > 0)
    {
      this->IsMillimetres = true;
      this->Scale = unit * length / box[2];
    }
  }

  void Draw(const XMLElement& element)
  {
    const State& state = this->States.back();
    bool isWhole = true;
    for (SVGLine& line : LinesOf(element, isWhole))
    {
      for (Point2& point : line.Points)
      {
        point = Apply(state.Matrix, point);
      }
      this->Lines.push_back({ state.Label, state.Layer, std::move(line) });
    }
    this->Broken += !isWhole;
    this->NotRead += element.Name == "text" || element.Name == "image" || element.Name == "use";
  }

  [[noreturn]] void Fail(const XMLElement& element, const std::string& sentence) const
  {
    throw Error(
      "Cannot read " + this->FileName + ", line " + std::to_string(element.Line) + ": " + sentence);
  }

  std::string FileName;
  std::vector<State> States;
};

void Tell(const Drawing& drawing, const std::string& name, TraceCollector& traces)
{
  const auto say = [&](std::size_t count, const char* noun, const char* what)
  {
    if (count > 0)
    {
      traces.Say(CleanName(name) + ": " + Counted(count, noun) + what);
    }
  };
  say(drawing.NotRead, "text, image or copy", " left out, which are no outlines.");
  say(drawing.Broken, "path", " with data that are none at the end; what comes before was read.");
  say(drawing.Hidden, "element", " left out, which are not displayed.");
}

std::string FileNameOf(const std::string& path)
{
  return std::filesystem::path(path).filename().string();
}
}

bool IsSVG(const std::string& fileName)
{
  const std::string start = ReadStart(fileName, StartSize);
  const std::size_t first = start.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return first != std::string::npos && start[first] == '<' &&
    start.find("<svg") != std::string::npos;
}

TracedFile ReadSVG(
  const std::vector<std::string>& fileNames, const SliceStack& stack, Monitor& monitor)
{
  TraceCollector traces;
  bool areMillimetres = true;
  for (std::size_t i = 0; i < fileNames.size(); ++i)
  {
    monitor.Update(static_cast<double>(i) / static_cast<double>(fileNames.size()), "reading");
    Drawing drawing(fileNames[i]);
    Monitor silent;
    ReadXML(fileNames[i], ReadTextFile(fileNames[i]), drawing, silent);
    Tell(drawing, FileNameOf(fileNames[i]), traces);
    areMillimetres = areMillimetres && drawing.IsMillimetres;
    const bool areLayersSlices = fileNames.size() == 1 && drawing.Layers > 1;
    const std::string rest = std::filesystem::path(fileNames.front()).stem().string();
    for (const DrawnLine& drawn : drawing.Lines)
    {
      const int slice = areLayersSlices ? std::max(0, drawn.Layer - 1) : static_cast<int>(i);
      std::vector<Point3> points;
      for (const Point2& point : drawn.Line.Points)
      {
        const double scale = stack.PixelSize * drawing.Scale;
        points.push_back({ scale * point[0], scale * point[1], stack.Spacing * slice });
      }
      TracedObject& object = traces.Named(drawn.Object.empty() ? rest : drawn.Object);
      traces.Add(object, points, drawn.Line.Closed, slice);
    }
  }
  if (areMillimetres && stack.PixelSize == 1)
  {
    traces.SetLengthUnit("mm");
  }
  return traces.Take(fileNames.empty() ? "the drawings" : fileNames.front());
}
}
