// SPDX-License-Identifier: GPL-3.0-or-later
#include "CollectionCases.h"

#include "Core/Polyhedral/NestedStacks.h"

#include "Base/BoundingBox.h"
#include "CurveNetwork/CurveNetworkParser.h"
#include "DICOM/StructureSetFile.h"
#include "Mesh/SurfaceSections.h"
#include "NodeDefaults.h"
#include "NUAGES/NUAGESParser.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

namespace recon::collection
{
namespace
{
/// No plane of it has three corners of a regular shape in line.
const Vector3 Oblique{ 0.36, 0.48, 0.8 };

std::ifstream Open(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  if (!file)
  {
    throw Error(fileName + " cannot be read.");
  }
  return file;
}

TriangleMesh ReadOFF(const std::string& fileName)
{
  std::ifstream file = Open(fileName);
  std::string word;
  std::size_t points = 0, triangles = 0, edges = 0;
  file >> word >> points >> triangles >> edges;
  TriangleMesh mesh;
  mesh.Points.resize(points);
  mesh.Triangles.resize(triangles);
  for (Point3& p : mesh.Points)
  {
    file >> p[0] >> p[1] >> p[2];
  }
  for (auto& t : mesh.Triangles)
  {
    int corners = 0;
    file >> corners >> t[0] >> t[1] >> t[2];
  }
  if (!file || word != "OFF")
  {
    throw Error(fileName + " is no .off file of triangles.");
  }
  return mesh;
}

Vector3 DirectionOf(int number)
{
  Vector3 direction{ 0, 0, 0 };
  if (number == 3)
  {
    return Oblique;
  }
  direction[static_cast<std::size_t>(number)] = 1;
  return direction;
}

/// From the lowest point of a mesh along a direction to the highest.
std::array<double, 2> ExtentAlong(const TriangleMesh& mesh, const Vector3& direction)
{
  std::array<double, 2> extent{ Dot(direction, mesh.Points[0]), Dot(direction, mesh.Points[0]) };
  for (const Point3& p : mesh.Points)
  {
    extent[0] = std::min(extent[0], Dot(direction, p));
    extent[1] = std::max(extent[1], Dot(direction, p));
  }
  return extent;
}

void Cut(const std::vector<std::string>& words, Case& made)
{
  const TriangleMesh mesh = ReadOFF(words.at(1));
  const PlanarFrame frame = PlanarFrame::About(DirectionOf(std::stoi(words.at(2))));
  const int slices = std::stoi(words.at(3));
  const double shift = std::stod(words.at(4));
  const auto [low, high] = ExtentAlong(mesh, frame.Normal);
  for (int i = 0; i < slices; ++i)
  {
    AppendSection(mesh, frame, low + (i + shift) * (high - low) / slices, made.Soup);
  }
}

/// Half of the planes are of the axes.
void CutByNetwork(const std::vector<std::string>& words, Case& made)
{
  const TriangleMesh mesh = ReadOFF(words.at(1));
  made.Seed = static_cast<unsigned>(std::stoul(words.at(2)));
  std::mt19937 random(made.Seed);
  std::normal_distribution<double> part;
  std::uniform_real_distribution<double> share(0.2, 0.8);
  for (int planes = 3 + static_cast<int>(random() % 4); planes > 0; --planes)
  {
    Vector3 normal = DirectionOf(static_cast<int>(random() % 3));
    if (random() % 2 == 0)
    {
      normal = { part(random), part(random), part(random) };
      normal = (1 / Norm(normal)) * normal;
    }
    const PlanarFrame frame = PlanarFrame::About(normal);
    const auto [low, high] = ExtentAlong(mesh, normal);
    AppendSection(mesh, frame, low + share(random) * (high - low), made.Soup);
  }
  made.Implicit = true;
  made.Cleaning.Parallel = false;
}

/// A line of three counts and three sizes of voxels, then a label a voxel, of two bytes, the first axis fastest.
class LabelMap
{
public:
  explicit LabelMap(const std::string& fileName)
  {
    std::ifstream file = Open(fileName);
    std::string line;
    std::getline(file, line);
    std::istringstream head(line);
    for (int& count : this->Count)
    {
      head >> count;
    }
    for (double& size : this->Size)
    {
      head >> size;
    }
    this->Labels.resize(static_cast<std::size_t>(this->Count[0]) * this->Count[1] * this->Count[2]);
    file.read(reinterpret_cast<char*>(this->Labels.data()),
      static_cast<std::streamsize>(this->Labels.size() * sizeof(std::int16_t)));
    if (!file || !head)
    {
      throw Error(fileName + " is no whole label map.");
    }
  }

  /// Edges of voxels with the label on one side, loose.
  void AppendOutlines(int label, std::size_t axis, int slice, LoopSoup& soup) const
  {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::array<int, 3> at{};
    at[axis] = slice;
    for (at[v] = 0; at[v] < this->Count[v]; ++at[v])
    {
      for (at[u] = 0; at[u] < this->Count[u]; ++at[u])
      {
        for (const auto& [along, across] : { std::pair(u, v), std::pair(v, u) })
        {
          std::array<int, 3> before = at;
          --before[along];
          if (this->Is(at, label) != this->Is(before, label))
          {
            std::array<int, 3> to = at;
            ++to[across];
            soup.Append({ this->CornerAt(at, axis), this->CornerAt(to, axis) }, false);
          }
        }
      }
    }
  }

  std::array<int, 3> Count{};

private:
  bool Is(const std::array<int, 3>& at, int label) const
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (at[k] < 0 || at[k] >= this->Count[k])
      {
        return false;
      }
    }
    return this
             ->Labels[(static_cast<std::size_t>(at[2]) * this->Count[1] + at[1]) * this->Count[0] +
               at[0]] == label;
  }

  /// Voxels about whole numbers: corners are half a voxel off, and slices go through the middle.
  Point3 CornerAt(const std::array<int, 3>& at, std::size_t axis) const
  {
    Point3 p{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      p[k] = this->Size[k] * (k == axis ? at[k] : at[k] - 0.5);
    }
    return p;
  }

  std::array<double, 3> Size{};
  std::vector<std::int16_t> Labels;
};

void Outline(const std::vector<std::string>& words, Case& made)
{
  const LabelMap map(words.at(1));
  const int label = std::stoi(words.at(2));
  const std::size_t axis = std::stoul(words.at(3));
  const int step = std::stoi(words.at(4));
  for (int slice = label % step; slice < map.Count.at(axis); slice += step)
  {
    map.AppendOutlines(label, axis, slice, made.Soup);
  }
}

std::string EndingOf(const std::string& fileName)
{
  return std::filesystem::path(fileName).extension().string();
}

void ReadRegion(const std::vector<std::string>& words, Case& made)
{
  Monitor monitor;
  const std::string ending = EndingOf(words.at(1));
  const int number = std::stoi(words.at(2));
  if (ending == ".cnt")
  {
    made.Soup = ReadNUAGES(words[1], monitor).Soup;
    return;
  }
  if (ending == ".dcm")
  {
    made.Soup = StructureSetFile(words[1]).ReadContours(number, monitor).File.Soup;
    return;
  }
  made.Soup =
    ReadCurveNetwork(words[1], monitor).Materials.at(static_cast<std::size_t>(number)).Soup;
}

void DrawNested(const std::vector<std::string>& words, Case& made)
{
  made.Seed = static_cast<unsigned>(std::stoul(words.at(1)));
  testing::NestedStack stack(made.Seed);
  made.Soup = stack.Soup;
  made.Cleaning = stack.Cleaning;
  made.Options = stack.Options;
}
}

Case MakeCase(const std::vector<std::string>& words)
{
  Case made;
  made.Options = testing::NodeOptions();
  const std::string kind = words.empty() ? "" : words[0];
  if (kind == "cut")
  {
    Cut(words, made);
  }
  else if (kind == "network")
  {
    CutByNetwork(words, made);
  }
  else if (kind == "label")
  {
    Outline(words, made);
  }
  else if (kind == "region")
  {
    ReadRegion(words, made);
  }
  else if (kind == "nested")
  {
    DrawNested(words, made);
  }
  else
  {
    throw Error("There is no kind of case " + kind + ".");
  }
  made.Options.PinchGap = 1e-3;
  made.Options.Threads = 1;
  return made;
}

std::vector<std::string> RegionsOf(const std::string& fileName)
{
  Monitor monitor;
  const std::string ending = EndingOf(fileName);
  if (ending == ".cnt")
  {
    return { "all" };
  }
  std::vector<std::string> names;
  if (ending == ".dcm")
  {
    const StructureSetFile file(fileName);
    for (const StructureSetROI& roi : file.GetROIs())
    {
      names.push_back(roi.Name);
    }
    return names;
  }
  for (const MaterialContours& material : ReadCurveNetwork(fileName, monitor).Materials)
  {
    names.push_back("material " + std::to_string(material.Label));
  }
  return names;
}
}
