// SPDX-License-Identifier: GPL-3.0-or-later
#include "NUAGES/NUAGESFormatter.h"

#include "Base/BoundingBox.h"
#include "Base/Text.h"
#include "Common/TextFile.h"

#include <algorithm>
#include <cmath>

namespace recon
{
namespace
{
constexpr double PlaneTolerance = 1e-6;

struct Loop
{
  std::vector<int> Points;
  double Z = 0;
  int Number = 0; ///< among the input's chains
};

Loop CheckedLoop(const LoopSoup& soup, int number, double tolerance)
{
  const LoopSoup::Chain& chain = soup.Chains[number];
  const std::string name = "Cannot write contour " + std::to_string(number) + ": ";
  if (!chain.Closed)
  {
    throw Error(name + "it is open, and NUAGES files hold closed contours only.");
  }
  if (chain.Points.empty())
  {
    throw Error(name + "it has no points.");
  }
  Loop loop{ chain.Points, soup.Points[chain.Points.front()][2], number };
  for (const int point : loop.Points)
  {
    const Point3& p = soup.Points[point];
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      throw Error(name + "it has a coordinate that is no finite number.");
    }
    if (std::abs(p[2] - loop.Z) > tolerance)
    {
      throw Error(name + "its plane is not perpendicular to z (it runs through " +
        Text(soup.Points[loop.Points.front()]) + " and " + Text(p) +
        "); rotate the contours with the Transform filter first.");
    }
  }
  while (
    loop.Points.size() > 1 && soup.Points[loop.Points.back()] == soup.Points[loop.Points.front()])
  {
    loop.Points.pop_back();
  }
  return loop;
}

/// Of a loop seen from +z, in square units: positive where it runs counterclockwise.
double SignedAreaInXY(const LoopSoup& soup, const std::vector<int>& loop)
{
  double twice = 0;
  const Point3& origin = soup.Points[loop.front()];
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Vector3 a = soup.Points[loop[i]] - origin;
    const Vector3 b = soup.Points[loop[(i + 1) % loop.size()]] - origin;
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2;
}

bool IsExactlyAt(const LoopSoup& soup, const Loop& loop, double z)
{
  return std::all_of(
    loop.Points.begin(), loop.Points.end(), [&](int point) { return soup.Points[point][2] == z; });
}

class Formatter
{
public:
  Formatter(const LoopSoup& soup, Monitor& monitor)
    : Soup(soup),
      Progress(monitor),
      Tolerance(PlaneTolerance * Box3::Around(soup.Points).Diagonal())
  {
  }

  std::string Format()
  {
    const int count = static_cast<int>(this->Soup.Chains.size());
    for (int i = 0; i < count; ++i)
    {
      this->Loops.push_back(CheckedLoop(this->Soup, i, this->Tolerance));
    }
    std::stable_sort(this->Loops.begin(), this->Loops.end(),
      [](const Loop& a, const Loop& b) { return a.Z < b.Z; });
    const std::vector<std::size_t> starts = this->SectionStarts();
    this->Text = "S " + std::to_string(starts.size() - 1) + "\n";
    for (std::size_t s = 0; s + 1 < starts.size(); ++s)
    {
      this->AppendSection(starts[s], starts[s + 1]);
      this->Progress.Update(
        static_cast<double>(s + 1) / static_cast<double>(starts.size()), "writing sections");
    }
    return std::move(this->Text);
  }

  std::vector<std::string> Report;

private:
  std::vector<std::size_t> SectionStarts() const
  {
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < this->Loops.size(); ++i)
    {
      if (starts.empty() || this->Loops[i].Z - this->Loops[starts.back()].Z > this->Tolerance)
      {
        starts.push_back(i);
      }
    }
    starts.push_back(this->Loops.size());
    return starts;
  }

  void AppendSection(std::size_t begin, std::size_t end)
  {
    const double z = this->Loops[begin].Z;
    // Within a section the order of the input, not that of rounding errors in z.
    std::sort(this->Loops.begin() + static_cast<std::ptrdiff_t>(begin),
      this->Loops.begin() + static_cast<std::ptrdiff_t>(end),
      [](const Loop& a, const Loop& b) { return a.Number < b.Number; });
    std::size_t vertices = 0;
    for (std::size_t i = begin; i < end; ++i)
    {
      vertices += this->Loops[i].Points.size();
    }
    this->Text += "v " + std::to_string(vertices) + " z ";
    AppendNumber(this->Text, z);
    this->Text += '\n';
    for (std::size_t i = begin; i < end; ++i)
    {
      this->AppendLoop(this->Loops[i], z);
    }
  }

  void AppendLoop(const Loop& loop, double z)
  {
    if (!IsExactlyAt(this->Soup, loop, z))
    {
      this->Report.push_back("Contour " + std::to_string(loop.Number) +
        ": its points are not all at one z; they were moved by less than " +
        "a millionth of the size of the data, to that of their section.");
    }
    this->Text += "{\n";
    for (const int point : loop.Points)
    {
      AppendNumber(this->Text, this->Soup.Points[point][0]);
      this->Text += ' ';
      AppendNumber(this->Text, this->Soup.Points[point][1]);
      this->Text += '\n';
    }
    this->Text += "}\n";
  }

  const LoopSoup& Soup;
  Monitor& Progress;
  double Tolerance;
  std::vector<Loop> Loops;
  std::string Text;
};
}

std::vector<std::string> WriteNUAGES(
  const std::string& fileName, const LoopSoup& loops, Monitor& monitor)
{
  Formatter formatter(loops, monitor);
  WriteTextFile(fileName, formatter.Format());
  return formatter.Report;
}

void OrientByDepth(const std::vector<int>& depths, LoopSoup& loops)
{
  for (LoopSoup::Chain& chain : loops.Chains)
  {
    if (chain.Source < 0 || chain.Source >= static_cast<int>(depths.size()) || chain.Points.empty())
    {
      continue;
    }
    const bool isHole = depths[chain.Source] % 2 != 0;
    const double area = SignedAreaInXY(loops, chain.Points);
    if (isHole ? area < 0 : area > 0)
    {
      std::reverse(chain.Points.begin() + 1, chain.Points.end());
    }
  }
}
}
