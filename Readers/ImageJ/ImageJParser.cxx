// SPDX-License-Identifier: GPL-3.0-or-later
#include "ImageJ/ImageJParser.h"

#include "Base/Text.h"
#include "Common/TextFile.h"
#include "Common/TextScanner.h"
#include "Common/ZIPFile.h"
#include "ImageJ/ImageJOutline.h"

#include <algorithm>
#include <filesystem>

namespace recon
{
namespace
{
constexpr std::size_t NameInZIPAt = 30; // of the first file, behind the archive's local header
constexpr std::size_t StartSize = 1024;

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string Stem(const std::string& name)
{
  return std::filesystem::path(name).stem().string();
}

/// The slice that ImageJ's own names begin with: 0012-0345 or 0012-0345-0678; 0 for any other.
int SliceOfName(const std::string& name)
{
  const std::size_t dash = name.find('-');
  int slice = 0;
  const bool isNumbers = name.find_first_not_of("0123456789-") == std::string::npos;
  const bool hasThree = dash != std::string::npos && name.find('-', dash + 1) != std::string::npos;
  return isNumbers && hasThree && ParseInteger(name.substr(0, dash), slice) ? slice : 0;
}

class Collection
{
public:
  Collection(const std::string& fileName, const SliceStack& stack)
    : FileName(fileName),
      Stack(stack)
  {
  }

  void Add(const std::string& entry, const std::string& bytes)
  {
    const ImageJOutline outline = ReadOutline(entry, bytes);
    const std::string name = outline.Name.empty() ? Stem(entry) : outline.Name;
    int slice = outline.Slice > 0 ? outline.Slice : SliceOfName(name);
    this->WithoutSlice += slice == 0;
    slice = std::max(slice, 1);
    const std::string object =
      outline.Group > 0 ? "group " + std::to_string(outline.Group) : Stem(this->FileName);
    TracedObject& traced = this->Traces.Named(object);
    if (outline.HasColor)
    {
      const auto byte = [&](unsigned int shift)
      { return static_cast<unsigned char>((outline.Color >> shift) & 0xff); };
      this->Traces.SetColor(traced, { byte(16), byte(8), byte(0) });
    }
    for (const ImageJOutline::Line& line : outline.Lines)
    {
      this->Traces.Add(
        traced, this->Placed(line.Points, slice), line.Closed, slice, CleanName(name));
    }
  }

  void Say(const std::string& sentence) { this->Traces.Say(sentence); }

  TracedFile Take()
  {
    if (this->WithoutSlice > 0)
    {
      this->Traces.Say(
        Counted(this->WithoutSlice, "ROI") + " on no slice in particular: taken as on the first.");
    }
    return this->Traces.Take(this->FileName);
  }

private:
  std::vector<Point3> Placed(const std::vector<Point2>& points, int slice) const
  {
    std::vector<Point3> placed;
    const double z = (slice - 1) * this->Stack.Spacing;
    for (const Point2& point : points)
    {
      placed.push_back({ point[0] * this->Stack.PixelSize, point[1] * this->Stack.PixelSize, z });
    }
    return placed;
  }

  std::string FileName;
  SliceStack Stack;
  TraceCollector Traces;
  std::size_t WithoutSlice = 0;
};
}

bool IsImageJ(const std::string& fileName)
{
  const std::string start = ReadStart(fileName, StartSize);
  if (start.compare(0, 4, "Iout") == 0)
  {
    return true;
  }
  const std::size_t dot = start.find(".roi", NameInZIPAt);
  return IsZIP(start) && dot != std::string::npos && start.size() > 28 &&
    dot - NameInZIPAt + 4 ==
    static_cast<unsigned char>(start[26]) + 256u * static_cast<unsigned char>(start[27]);
}

TracedFile ReadImageJ(const std::string& fileName, const SliceStack& stack, Monitor& monitor)
{
  const std::string bytes = ReadTextFile(fileName);
  Collection collection(fileName, stack);
  if (!IsZIP(bytes.substr(0, 4)))
  {
    collection.Add(fileName, bytes);
    return collection.Take();
  }
  std::size_t others = 0;
  std::vector<std::string> report;
  const auto take = [&](const std::string& name, const std::string& content)
  {
    if (!EndsWith(name, ".roi"))
    {
      ++others;
      return;
    }
    try
    {
      collection.Add(CleanName(name), content);
    }
    catch (const Error& error)
    {
      report.push_back(std::string("Left out an ROI: ") + error.what());
    }
  };
  ReadZIP(fileName, bytes, take, report, monitor);
  if (others > 0)
  {
    report.push_back(Counted(others, "file") + " of the archive left out, which are no ROIs.");
  }
  for (const std::string& line : report)
  {
    collection.Say(line);
  }
  return collection.Take();
}
}
