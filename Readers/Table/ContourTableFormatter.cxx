// SPDX-License-Identifier: GPL-3.0-or-later
#include "Table/ContourTableFormatter.h"

#include "Base/Text.h"
#include "Common/TextFile.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace recon
{
namespace
{
/// A name on one line and in one cell.
std::string PlainName(const std::string& name)
{
  std::string plain;
  for (const char c : name)
  {
    plain += c == '"' ? '\'' : static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  const std::size_t first = plain.find_first_not_of(' ');
  const std::size_t last = plain.find_last_not_of(' ');
  return first == std::string::npos ? "object" : plain.substr(first, last - first + 1);
}

class Formatter
{
public:
  Formatter(const TracedFile& file, Monitor& monitor) : File(file), Progress(monitor) {}

  std::string Format()
  {
    this->HasSlices = std::all_of(this->File.Objects.begin(), this->File.Objects.end(),
      [](const TracedObject& object) { return object.Slices.size() == object.Soup.Chains.size(); });
    const std::string unit =
      this->File.LengthUnit.empty() ? "" : " (" + this->File.LengthUnit + ")";
    this->Text = std::string("object,") + (this->HasSlices ? "slice," : "") + "contour,x" + unit +
      ",y" + unit + ",z" + unit + "\n";
    std::size_t done = 0;
    for (const TracedObject& object : this->File.Objects)
    {
      this->AppendObject(object);
      this->Progress.Update(
        static_cast<double>(++done) / static_cast<double>(this->File.Objects.size()),
        "writing contours");
    }
    if (this->Written == 0)
    {
      throw Error("There are no closed contours to write.");
    }
    if (this->LeftOut > 0)
    {
      this->Report.push_back(Counted(this->LeftOut, "open line or point") +
        " left out: a table of contours holds closed ones.");
    }
    return std::move(this->Text);
  }

  std::vector<std::string> Report;

private:
  void AppendObject(const TracedObject& object)
  {
    std::string name;
    std::size_t number = 0;
    for (std::size_t c = 0; c < object.Soup.Chains.size(); ++c)
    {
      const std::vector<int> loop = LoopOf(object.Soup, object.Soup.Chains[c]);
      if (loop.empty())
      {
        ++this->LeftOut;
        continue;
      }
      name = name.empty() ? this->UniqueName(object.Name) : name;
      const std::string slice = this->HasSlices ? std::to_string(object.Slices[c]) + "," : "";
      this->AppendLoop("\"" + name + "\"," + slice + std::to_string(number++) + ",", object.Soup,
        loop, object.Name);
    }
    this->Written += number;
  }

  /// Its points, the first not again at the end; none where it is no closed contour.
  static std::vector<int> LoopOf(const LoopSoup& soup, const LoopSoup::Chain& chain)
  {
    std::vector<int> loop = chain.Points;
    while (loop.size() > 1 && soup.Points[loop.front()] == soup.Points[loop.back()])
    {
      loop.pop_back();
    }
    return chain.Closed && loop.size() > 2 ? loop : std::vector<int>();
  }

  /// The name, by which an object is known, so no other's.
  std::string UniqueName(const std::string& name)
  {
    const std::string plain = PlainName(name);
    std::string unique = plain;
    for (int more = 2; !this->Names.insert(unique).second; ++more)
    {
      unique = plain + " (" + std::to_string(more) + ")";
    }
    if (unique != name)
    {
      this->Report.push_back("\"" + unique + "\" in the table is \"" + name + "\" here.");
    }
    return unique;
  }

  /// Where in its points a loop begins: just before z changes, so that its first piece of one z is one
  /// point, and the reader does not take each such piece for a contour.
  static std::size_t StartOf(const LoopSoup& soup, const std::vector<int>& loop)
  {
    const auto z = [&](std::size_t i) { return soup.Points[loop[i % loop.size()]][2]; };
    const bool isLevel =
      std::all_of(loop.begin(), loop.end(), [&](int p) { return soup.Points[p][2] == z(0); });
    for (std::size_t i = 0; !isLevel && i < loop.size(); ++i)
    {
      if (z(i) != z(i + 1))
      {
        return i; // a piece of one point
      }
    }
    return 0;
  }

  void AppendLoop(const std::string& row, const LoopSoup& soup, const std::vector<int>& loop,
    const std::string& name)
  {
    const std::size_t start = StartOf(soup, loop);
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Point3& point = soup.Points[loop[(start + i) % loop.size()]];
      this->Text += row;
      for (int c = 0; c < 3; ++c)
      {
        if (!std::isfinite(point[c]))
        {
          throw Error("\"" + name + "\" has a coordinate that is no finite number.");
        }
        AppendNumber(this->Text, point[c]);
        this->Text += c < 2 ? ',' : '\n';
      }
    }
  }

  const TracedFile& File;
  Monitor& Progress;
  bool HasSlices = false;
  std::set<std::string> Names;
  std::size_t Written = 0;
  std::size_t LeftOut = 0;
  std::string Text;
};
}

std::vector<std::string> WriteContourTable(
  const std::string& fileName, const TracedFile& file, Monitor& monitor)
{
  Formatter formatter(file, monitor);
  WriteTextFile(fileName, formatter.Format());
  return formatter.Report;
}
}
