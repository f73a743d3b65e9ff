// SPDX-License-Identifier: GPL-3.0-or-later
#include "IMOD/IMODParser.h"

#include "Base/Text.h"
#include "Common/BinaryScanner.h"
#include "Common/TextFile.h"
#include "Common/TextScanner.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace recon
{
namespace
{
constexpr std::string_view Magic = "IMODV1.";
constexpr std::size_t ModelNameSize = 128;
constexpr std::size_t ObjectNameSize = 64;
constexpr std::size_t ObjectExtraSize = 64;
constexpr std::size_t BytesPerPoint = 12;
constexpr std::uint32_t OpenFlag = 1u << 3;
constexpr std::uint32_t ScatteredFlag = 1u << 9;

/// A unit of the header by its exponent; a name of ours, and what a length in it is multiplied by.
struct Unit
{
  int Code;
  const char* Name;
  double Factor;
};
constexpr Unit Units[] = { { 3, "km", 1 }, { 1, "m", 1 }, { -2, "cm", 1 }, { -3, "mm", 1 },
  { -6, "um", 1 }, { -9, "nm", 1 }, { -10, "nm", 0.1 }, { -12, "nm", 1e-3 } };

const Unit* UnitOf(int code)
{
  for (const Unit& unit : Units)
  {
    if (unit.Code == code)
    {
      return &unit;
    }
  }
  return nullptr;
}

/// Up to the first zero byte.
std::string_view Text0(std::string_view bytes)
{
  return bytes.substr(0, bytes.find('\0'));
}

bool IsChunkName(std::string_view name)
{
  for (const char c : name)
  {
    if (!((c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ' || c == '_'))
    {
      return false;
    }
  }
  return true;
}

unsigned char ColorByte(float value)
{
  return static_cast<unsigned char>(value > 0 ? std::lround(255 * std::min(value, 1.0f)) : 0);
}

int SliceOf(float z)
{
  constexpr float most = 1e9f;
  return std::isfinite(z) && std::abs(z) < most ? static_cast<int>(std::lround(z)) : 0;
}

class Parser
{
public:
  Parser(const std::string& fileName, const std::string& bytes, Monitor& monitor)
    : FileName(fileName),
      Scanner(fileName, bytes),
      Progress(monitor)
  {
  }

  TracedFile Read()
  {
    if (this->Scanner.BytesLeft() < Magic.size() + 1 ||
      this->Scanner.Take(Magic.size(), "the first word") != Magic)
    {
      throw Error("Cannot read " + this->FileName +
        ": it does not begin with IMODV1.2, as a binary IMOD model does; save it by 3dmod or by "
        "imodauto, not as text.");
    }
    this->Scanner.Skip(1, "the version");
    this->ReadHeader();
    while (this->ReadChunk())
    {
      this->Progress.Update(this->Scanner.GetFraction(), "reading objects");
    }
    this->CheckCounts();
    if (this->Objects != this->AnnouncedObjects)
    {
      this->Traces.Say("The model announces " + std::to_string(this->AnnouncedObjects) +
        " objects, and has " + std::to_string(this->Objects) + ".");
    }
    return this->Traces.Take(this->FileName);
  }

private:
  void ReadHeader()
  {
    const char* const what = "the header";
    this->Scanner.Skip(ModelNameSize + 3 * 4, what); // the model's name, and the image's size
    this->AnnouncedObjects = this->Scanner.Int32(what);
    this->Scanner.Skip(
      5 * 4 + 3 * 4 + 2 * 4, what); // flags to white level, offsets, scales of x, y
    const double zScale = this->Scanner.Float(what);
    this->Scanner.Skip(5 * 4, what); // what is current, resolution, threshold
    const double pixel = this->Scanner.Float(what);
    const int code = this->Scanner.Int32(what);
    this->Scanner.Skip(4 * 4, what); // checksum, angles
    const Unit* unit = UnitOf(code);
    if (unit && pixel > 0 && std::isfinite(pixel))
    {
      this->PixelSize = pixel * unit->Factor;
      this->Traces.SetLengthUnit(unit->Name);
    }
    else
    {
      this->Traces.Say("The model tells no pixel size, so that coordinates are pixels.");
    }
    this->PixelHeight = this->PixelSize * (zScale > 0 && std::isfinite(zScale) ? zScale : 1.0);
  }

  /// Returns false at the end of the model.
  bool ReadChunk()
  {
    const std::string_view name = this->Scanner.Take(4, "a model without its end mark (IEOF)");
    if (name == "IEOF")
    {
      return false;
    }
    if (name == "OBJT")
    {
      this->ReadObject();
    }
    else if (name == "CONT")
    {
      this->ReadContour();
    }
    else if (name == "MESH")
    {
      this->SkipMesh();
    }
    else if (IsChunkName(name))
    {
      this->Scanner.Skip(this->Scanner.Count("the size of a chunk", 1), "a chunk");
    }
    else
    {
      this->Scanner.Fail("expected the name of a chunk, found " + Quoted(name) + ".");
    }
    return true;
  }

  void ReadObject()
  {
    this->CheckCounts();
    const char* const what = "an object's header";
    const std::string name(Text0(this->Scanner.Take(ObjectNameSize, what)));
    this->Scanner.Skip(ObjectExtraSize, what);
    this->AnnouncedContours = this->Scanner.Int32(what);
    this->ObjectFlags = this->Scanner.UInt32(what);
    this->Scanner.Skip(2 * 4, what);
    const float red = this->Scanner.Float(what);
    const float green = this->Scanner.Float(what);
    const float blue = this->Scanner.Float(what);
    this->Scanner.Skip(4 + 8 + 2 * 4, what); // symbols and line widths, numbers of meshes, surfaces
    ++this->Objects;
    const std::string number = "object " + std::to_string(this->Objects);
    this->Name = CleanName(name);
    this->Name = name.empty() ? number
      : this->IsTaken()       ? this->Name + " (" + number + ")"
                              : this->Name;
    this->Names.push_back(this->Name);
    this->Traces.SetColor(
      this->Traces.Named(this->Name), { ColorByte(red), ColorByte(green), ColorByte(blue) });
    this->Contours = 0;
  }

  /// Objects of one name are objects of their own in IMOD.
  bool IsTaken() const
  {
    return std::find(this->Names.begin(), this->Names.end(), this->Name) != this->Names.end();
  }

  void ReadContour()
  {
    if (this->Objects == 0)
    {
      this->Scanner.Fail("a contour comes before any object.");
    }
    const std::size_t count =
      this->Scanner.Count("the number of a contour's points", BytesPerPoint);
    const std::uint32_t flags = this->Scanner.UInt32("a contour's header");
    this->Scanner.Skip(2 * 4, "a contour's header"); // time, surface
    std::vector<Point3> points;
    int slice = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      const float x = this->Scanner.Float("a point");
      const float y = this->Scanner.Float("a point");
      const float z = this->Scanner.Float("a point");
      slice = i == 0 ? SliceOf(z) : slice;
      points.push_back({ x * this->PixelSize, y * this->PixelSize, z * this->PixelHeight });
    }
    ++this->Contours;
    this->AddContour(points, flags, slice);
  }

  void AddContour(const std::vector<Point3>& points, std::uint32_t flags, int slice)
  {
    TracedObject& object = this->Traces.Named(this->Name);
    if (this->ObjectFlags & ScatteredFlag)
    {
      for (const Point3& point : points)
      {
        this->Traces.Add(object, { point }, false, slice);
      }
      return;
    }
    this->Traces.Add(object, points, !((this->ObjectFlags | flags) & OpenFlag), slice);
  }

  void SkipMesh()
  {
    const std::size_t vertices =
      this->Scanner.Count("the number of a mesh's vertices", BytesPerPoint);
    const std::size_t indices = this->Scanner.Count("the number of a mesh's indices", 4);
    this->Scanner.Skip(2 * 4, "a mesh's header");
    this->Scanner.Skip(vertices * BytesPerPoint, "a mesh");
    this->Scanner.Skip(indices * 4, "a mesh");
  }

  /// What an object, and at the end the model, announced and what came.
  void CheckCounts()
  {
    if (this->Objects > 0 && this->Contours != this->AnnouncedContours)
    {
      this->Traces.Say("\"" + this->Name + "\" announces " +
        std::to_string(this->AnnouncedContours) + " contours, and has " +
        std::to_string(this->Contours) + ".");
    }
    this->Contours = this->AnnouncedContours; // said once
  }

  std::string FileName;
  BinaryScanner Scanner;
  Monitor& Progress;
  TraceCollector Traces;
  std::vector<std::string> Names;
  std::string Name; // of the object that is read
  std::uint32_t ObjectFlags = 0;
  int Objects = 0;
  int Contours = 0;
  int AnnouncedObjects = 0;
  int AnnouncedContours = 0;
  double PixelSize = 1;
  double PixelHeight = 1;
};
}

bool IsIMOD(const std::string& fileName)
{
  return ReadStart(fileName, Magic.size()) == Magic;
}

TracedFile ReadIMOD(const std::string& fileName, Monitor& monitor)
{
  const std::string bytes = ReadTextFile(fileName);
  return Parser(fileName, bytes, monitor).Read();
}
}
