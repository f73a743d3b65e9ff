// SPDX-License-Identifier: GPL-3.0-or-later
#include "Reconstruct/JSONSeries.h"

#include "Base/Text.h"
#include "Common/JSONText.h"
#include "Common/TextScanner.h"
#include "Reconstruct/ReconstructSections.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace recon
{
namespace
{
constexpr const char* LengthUnit = "um"; // of all that PyReconstruct writes
constexpr const char* NoAlignment = "no-alignment";

/// Where the parts of a trace stand in its list, without a name before them.
enum Part : std::size_t
{
  X,
  Y,
  Color,
  Closed
};

/// A part of a trace, which is a list in newer files and an object in older ones.
const JSONValue* PartOf(const JSONValue& trace, Part part, const char* name)
{
  if (trace.IsObject())
  {
    return trace.Find(name);
  }
  return part < trace.Items.size() ? &trace.Items[part] : nullptr;
}

class Reader
{
public:
  Reader(std::string fileName, Monitor& monitor) : FileName(std::move(fileName)), Progress(monitor)
  {
  }

  TracedFile Read(const JSONValue& file)
  {
    if (!file.IsObject())
    {
      this->Fail("expected an object with the series and its sections.");
    }
    this->Alignment = AlignmentOf(file);
    this->Collector.SetLengthUnit(LengthUnit);
    if (const JSONValue* sections = file.Find("sections"))
    {
      this->ReadSections(*sections);
    }
    else
    {
      this->ReadNamedSections(file);
    }
    if (this->Damaged > 0)
    {
      this->Collector.Say(
        Counted(this->Damaged, "trace") + " left out: not as many x as y, or no numbers.");
    }
    PlaceSections(this->All, this->Collector, this->Progress);
    return this->Collector.Take(this->FileName);
  }

private:
  static std::string AlignmentOf(const JSONValue& file)
  {
    const JSONValue* series = file.Find("series");
    if (!series)
    {
      const auto found = std::find_if(file.Pairs.begin(), file.Pairs.end(),
        [](const auto& pair)
        {
          const std::string& name = pair.first;
          return name.size() > 4 && name.compare(name.size() - 4, 4, ".ser") == 0;
        });
      series = found == file.Pairs.end() ? nullptr : &found->second;
    }
    const JSONValue* alignment = series ? series->Find("alignment") : nullptr;
    return alignment && alignment->IsString() ? alignment->String : "default";
  }

  void ReadSections(const JSONValue& sections)
  {
    for (std::size_t i = 0; i < sections.Items.size(); ++i)
    {
      this->ReadSection(std::to_string(i), sections.Items[i]);
    }
    for (const auto& [name, section] : sections.Pairs)
    {
      this->ReadSection(name, section);
    }
  }

  /// NAME.N of the oldest files.
  void ReadNamedSections(const JSONValue& file)
  {
    for (const auto& [name, section] : file.Pairs)
    {
      const std::string number = name.substr(name.rfind('.') + 1);
      if (number != "ser")
      {
        this->ReadSection(number, section);
      }
    }
  }

  void ReadSection(const std::string& number, const JSONValue& section)
  {
    int index = 0;
    const JSONValue* contours = section.Find("contours");
    if (!ParseInteger(number, index) || !contours || !contours->IsObject())
    {
      return; // what is not there holds nothing; a series without any section is an error
    }
    const JSONValue* thickness = section.Find("thickness");
    if (!thickness || !thickness->IsNumber() || !(thickness->Number > 0))
    {
      this->Collector.Say("Section " + number + ": left out, it has no thickness above 0.");
      return;
    }
    const std::optional<SectionTransform> transform = this->TransformOf(section);
    if (!transform)
    {
      this->Collector.Say("Section " + number +
        ": left out, it has no transform of the alignment \"" + CleanName(this->Alignment) + "\".");
      return;
    }
    Section& read = this->All[index];
    read.Thickness = thickness->Number;
    for (const auto& [name, traces] : contours->Pairs)
    {
      for (const JSONValue& trace : traces.Items)
      {
        this->ReadTrace(name, trace, *transform, read);
      }
    }
  }

  std::optional<SectionTransform> TransformOf(const JSONValue& section) const
  {
    if (this->Alignment == NoAlignment)
    {
      return SectionTransform();
    }
    const JSONValue* transforms = section.Find("tforms");
    const JSONValue* numbers = transforms ? transforms->Find(this->Alignment) : nullptr;
    std::array<double, 6> affine{};
    if (!numbers || numbers->Numbers.size() != affine.size())
    {
      return std::nullopt;
    }
    std::copy(numbers->Numbers.begin(), numbers->Numbers.end(), affine.begin());
    return SectionTransform::FromAffine(affine);
  }

  void ReadTrace(const std::string& name, const JSONValue& trace, const SectionTransform& transform,
    Section& section)
  {
    const JSONValue* x = PartOf(trace, X, "x");
    const JSONValue* y = PartOf(trace, Y, "y");
    if (!x || !y || !x->Items.empty() || !y->Items.empty() ||
      x->Numbers.size() != y->Numbers.size())
    {
      ++this->Damaged;
      return;
    }
    SectionTrace read;
    read.Name = name;
    read.Transform = transform;
    const JSONValue* closed = PartOf(trace, Closed, "closed");
    read.Closed = !closed || closed->Type != JSONValue::Kind::Boolean || closed->Boolean;
    this->ReadColor(PartOf(trace, Color, "color"), read);
    for (std::size_t i = 0; i < x->Numbers.size(); ++i)
    {
      read.Points.push_back({ x->Numbers[i], y->Numbers[i] });
    }
    section.Traces.push_back(std::move(read));
  }

  static void ReadColor(const JSONValue* color, SectionTrace& trace)
  {
    if (!color || color->Numbers.size() != trace.Color.size())
    {
      return;
    }
    trace.HasColor = true;
    for (std::size_t i = 0; i < trace.Color.size(); ++i)
    {
      trace.Color[i] =
        static_cast<unsigned char>(std::lround(std::clamp(color->Numbers[i], 0.0, 255.0)));
    }
  }

  [[noreturn]] void Fail(const std::string& sentence) const
  {
    throw Error("Cannot read " + this->FileName + ": " + sentence);
  }

  std::string FileName;
  Monitor& Progress;
  TraceCollector Collector;
  std::string Alignment;
  Sections All;
  std::size_t Damaged = 0;
};
}

TracedFile ReadJSONSeries(const std::string& fileName, const std::string& text, Monitor& monitor)
{
  return Reader(fileName, monitor).Read(ReadJSON(fileName, text, monitor));
}
}
