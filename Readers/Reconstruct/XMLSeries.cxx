// SPDX-License-Identifier: GPL-3.0-or-later
#include "Reconstruct/XMLSeries.h"

#include "Base/Text.h"
#include "Common/TextFile.h"
#include "Common/TextScanner.h"
#include "Common/XMLText.h"
#include "Reconstruct/ReconstructSections.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <sstream>

namespace recon
{
namespace
{
[[noreturn]] void Fail(const std::string& fileName, int line, const std::string& sentence)
{
  throw Error("Cannot read " + fileName + ", line " + std::to_string(line) + ": " + sentence);
}

/// Numbers in a text, whatever commas and spaces are between them; nothing where one is none.
std::optional<std::vector<double>> NumbersIn(std::string text)
{
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream words(text);
  std::vector<double> numbers;
  std::string word;
  while (words >> word)
  {
    numbers.push_back(0);
    if (!ParseNumber(word, numbers.back()))
    {
      return std::nullopt;
    }
  }
  return numbers;
}

/// "1 0.5 0" to bytes.
bool ParseColor(const std::string& text, std::array<unsigned char, 3>& color)
{
  const auto numbers = NumbersIn(text);
  if (!numbers || numbers->size() != color.size())
  {
    return false;
  }
  for (std::size_t i = 0; i < color.size(); ++i)
  {
    color[i] = static_cast<unsigned char>(std::lround(255 * std::clamp((*numbers)[i], 0.0, 1.0)));
  }
  return true;
}

/// The traces of one section file.
class SectionHandler : public XMLHandler
{
public:
  explicit SectionHandler(std::string fileName) : FileName(std::move(fileName)) {}

  void Begin(const XMLElement& element) override
  {
    if (element.Name == "Section")
    {
      this->ReadSection(element);
    }
    else if (element.Name == "Transform")
    {
      this->ReadTransform(element);
    }
    else if (element.Name == "Image")
    {
      this->IsOfImage = true; // what is traced beside an image is the image's own border
    }
    else if (element.Name == "Contour" && !this->IsOfImage)
    {
      this->ReadTrace(element);
    }
  }

  void End(const std::string& name) override { this->IsOfImage &= name != "Transform"; }

  std::optional<int> Index;
  Section Read;

private:
  void ReadSection(const XMLElement& element)
  {
    int index = 0;
    if (!ParseInteger(element.Get("index"), index))
    {
      Fail(this->FileName, element.Line, "the section has no index.");
    }
    this->Index = index;
    if (!ParseNumber(element.Get("thickness"), this->Read.Thickness) || !(this->Read.Thickness > 0))
    {
      Fail(this->FileName, element.Line, "the section has no thickness above 0.");
    }
  }

  void ReadTransform(const XMLElement& element)
  {
    this->IsOfImage = false;
    int dimension = 0;
    std::array<double, 6> x{};
    std::array<double, 6> y{};
    if (!ParseInteger(element.Get("dim"), dimension) || dimension < 0 || dimension > 6 ||
      !ParseCoefficients(element.Get("xcoef"), x) || !ParseCoefficients(element.Get("ycoef"), y))
    {
      Fail(this->FileName, element.Line,
        "expected a transform of dimension 0 to 6 with six numbers in xcoef and in ycoef.");
    }
    // Dimension 0 is none, whatever the coefficients; 1 is a shift alone.
    this->Transform = dimension == 0 ? SectionTransform()
      : dimension == 1
      ? SectionTransform::FromInverse({ x[0], 1, 0, 0, 0, 0 }, { y[0], 0, 1, 0, 0, 0 })
      : SectionTransform::FromInverse(x, y);
  }

  void ReadTrace(const XMLElement& element)
  {
    const auto numbers = NumbersIn(element.Get("points"));
    if (!numbers || numbers->size() % 2 != 0)
    {
      Fail(this->FileName, element.Line,
        "the points of trace " + Quoted(element.Get("name")) + " are no pairs of numbers.");
    }
    SectionTrace trace;
    trace.Name = element.Get("name");
    trace.Closed = element.Get("closed") != "false";
    trace.HasColor = ParseColor(element.Get("border"), trace.Color);
    trace.Transform = this->Transform;
    for (std::size_t i = 0; i < numbers->size(); i += 2)
    {
      trace.Points.push_back({ (*numbers)[i], (*numbers)[i + 1] });
    }
    this->Read.Traces.push_back(std::move(trace));
  }

  std::string FileName;
  SectionTransform Transform;
  bool IsOfImage = false;
};

/// What a series file itself tells.
class SeriesHandler : public XMLHandler
{
public:
  void Begin(const XMLElement& element) override
  {
    if (element.Name == "Series")
    {
      this->Units = element.Get("units");
    }
    this->Lines += element.Name == "ZContour";
  }
  void End(const std::string&) override {}

  std::string Units;
  std::size_t Lines = 0;
};

/// Files NAME.N of the folder, by N.
std::map<int, std::string> SectionFiles(const std::string& fileName)
{
  namespace fs = std::filesystem;
  const fs::path path(fileName);
  const std::string stem = path.stem().string();
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::map<int, std::string> files;
  std::error_code status;
  for (const auto& entry : fs::directory_iterator(folder, status))
  {
    const std::string extension = entry.path().extension().string();
    int number = 0;
    if (entry.path().stem().string() == stem && extension.size() > 1 &&
      ParseInteger(extension.substr(1), number) && number >= 0)
    {
      files[number] = entry.path().string();
    }
  }
  return files;
}

/// Adds a section, or a line of why not.
void AddSection(
  const std::string& file, Sections& sections, TraceCollector& collector, Monitor& monitor)
{
  try
  {
    SectionHandler handler(file);
    ReadXML(file, ReadTextFile(file), handler, monitor);
    if (!handler.Index)
    {
      throw Error("Cannot read " + file + ": it has no element Section.");
    }
    if (!sections.emplace(*handler.Index, std::move(handler.Read)).second)
    {
      collector.Say("Section file " + CleanName(file) + ": left out, index " +
        std::to_string(*handler.Index) + " is that of another file as well.");
    }
  }
  catch (const Error& error)
  {
    collector.Say(std::string("Left out a section: ") + error.what());
  }
}

std::string UnitNamed(const std::string& units)
{
  static const std::map<std::string, std::string> names{ { "microns", "um" },
    { "millimeters", "mm" }, { "nanometers", "nm" } };
  const auto found = names.find(units);
  return found == names.end() ? std::string() : found->second;
}
}

TracedFile ReadXMLSeries(const std::string& fileName, const std::string& text, Monitor& monitor)
{
  SeriesHandler series;
  ReadXML(fileName, text, series, monitor);
  const std::map<int, std::string> files = SectionFiles(fileName);
  if (files.empty())
  {
    throw Error("Cannot read " + fileName + ": there are no section files beside it (" +
      std::filesystem::path(fileName).stem().string() + ".1 and so on); copy them as well.");
  }
  TraceCollector collector;
  collector.SetLengthUnit(UnitNamed(series.Units));
  Sections sections;
  for (const auto& [number, file] : files)
  {
    AddSection(file, sections, collector, monitor);
  }
  if (series.Lines > 0)
  {
    collector.Say(Counted(series.Lines, "trace") +
      " of the series left out: they run across sections, and are no contours.");
  }
  PlaceSections(sections, collector, monitor);
  return collector.Take(fileName);
}
}
