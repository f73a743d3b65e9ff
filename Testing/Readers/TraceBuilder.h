// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file TraceBuilder.h
 * @brief Small files of tracing programs, made by the layout that their formats document.
 */
#ifndef TraceBuilder_h
#define TraceBuilder_h

#include "Common/TracedFile.h"

#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace tracebuilder
{
/// Numbers with their highest byte first.
class BigEndian
{
public:
  BigEndian& Text(const std::string& text, std::size_t size)
  {
    std::string padded = text;
    padded.resize(size, '\0');
    this->Content += padded;
    return *this;
  }
  BigEndian& Int(std::int64_t value, int bytes = 4)
  {
    for (int i = bytes - 1; i >= 0; --i)
    {
      this->Content += static_cast<char>((value >> (8 * i)) & 0xff);
    }
    return *this;
  }
  BigEndian& Ints(std::int64_t value, int count)
  {
    for (int i = 0; i < count; ++i)
    {
      this->Int(value);
    }
    return *this;
  }
  BigEndian& Float(float value)
  {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    return this->Int(bits);
  }
  BigEndian& Append(const std::string& bytes)
  {
    this->Content += bytes;
    return *this;
  }
  /// Little-endian, for archives.
  BigEndian& Small(std::size_t value, int bytes)
  {
    for (int i = 0; i < bytes; ++i)
    {
      this->Content += static_cast<char>((value >> (8 * i)) & 0xff);
    }
    return *this;
  }
  void Put(std::size_t at, const std::string& bytes)
  {
    this->Content.replace(at, bytes.size(), bytes);
  }

  std::string Content;
};

/// "IMODV1.2" and the header: pixels of 2.5 units with that exponent, z three times as high.
inline std::string IMODHeader(int objects, int unit = -9)
{
  BigEndian bytes;
  bytes.Text("IMODV1.2", 8).Text("Model", 128).Ints(100, 3).Int(objects).Ints(0, 5);
  for (const float value : { 0.f, 0.f, 0.f, 1.f, 1.f, 3.f })
  {
    bytes.Float(value);
  }
  return bytes.Ints(0, 5).Float(2.5f).Int(unit).Ints(0, 4).Content;
}

inline std::string IMODObject(const std::string& name, int contours, std::uint32_t flags = 0)
{
  BigEndian bytes;
  bytes.Text("OBJT", 4).Text(name, 64).Ints(0, 16).Int(contours).Int(flags).Ints(0, 2);
  return bytes.Float(1.f).Float(.5f).Float(0.f).Ints(0, 5).Content;
}

inline std::string IMODContour(const std::vector<recon::Point3>& points, std::uint32_t flags = 0)
{
  BigEndian bytes;
  bytes.Text("CONT", 4).Int(static_cast<std::int64_t>(points.size())).Int(flags).Ints(0, 2);
  for (const recon::Point3& point : points)
  {
    for (const double x : point)
    {
      bytes.Float(static_cast<float>(x));
    }
  }
  return bytes.Content;
}

/// A polygon in whole pixels, or of any other type, on a slice, with a name.
inline std::string ROI(const std::vector<std::pair<int, int>>& points, int slice,
  const std::string& name, int type = 0, int group = 0)
{
  const int left = 10;
  const int top = 20;
  BigEndian bytes;
  bytes.Text("Iout", 4).Int(228, 2).Int(type, 1).Int(0, 1);
  bytes.Int(top, 2).Int(left, 2).Int(top + 8, 2).Int(left + 4, 2);
  bytes.Int(static_cast<std::int64_t>(points.size()), 2).Text("", 16).Int(0, 2).Int(0);
  bytes.Int(0xff0080ff).Int(0).Int(0, 2).Int(0, 2).Text("", 4).Int(slice);
  const std::size_t second = 64 + 4 * points.size();
  bytes.Int(static_cast<std::int64_t>(second));
  for (const auto& point : points)
  {
    bytes.Int(point.first - left, 2);
  }
  for (const auto& point : points)
  {
    bytes.Int(point.second - top, 2);
  }
  BigEndian header;
  header.Ints(0, 4).Int(static_cast<std::int64_t>(second + 64));
  header.Int(static_cast<std::int64_t>(name.size())).Text("", 6).Int(group, 1).Text("", 33);
  for (const char c : name)
  {
    header.Int(c, 2);
  }
  return bytes.Append(header.Content).Content;
}

/// An archive of files that are stored as they are.
inline std::string ZIP(const std::vector<std::pair<std::string, std::string>>& files)
{
  BigEndian archive;
  BigEndian directory;
  for (const auto& [name, content] : files)
  {
    const std::size_t at = archive.Content.size();
    const auto common = [&content = content, &name = name](BigEndian& bytes)
    {
      bytes.Small(20, 2).Small(0, 2).Small(0, 2).Small(0, 4).Small(0, 4);
      bytes.Small(content.size(), 4).Small(content.size(), 4).Small(name.size(), 2).Small(0, 2);
    };
    archive.Text("PK\x03\x04", 4);
    common(archive);
    archive.Append(name).Append(content);
    directory.Text("PK\x01\x02", 4).Small(20, 2);
    common(directory);
    directory.Small(0, 2).Small(0, 2).Small(0, 2).Small(0, 4).Small(at, 4).Append(name);
  }
  const std::size_t at = archive.Content.size();
  archive.Append(directory.Content).Text("PK\x05\x06", 4).Small(0, 2).Small(0, 2);
  archive.Small(files.size(), 2).Small(files.size(), 2).Small(directory.Content.size(), 4);
  return archive.Small(at, 4).Small(0, 2).Content;
}

/// A section file of Reconstruct with one trace in its transform.
inline std::string SectionFile(
  int index, const std::string& transform, const std::string& points, const std::string& more = "")
{
  return "<?xml version=\"1.0\"?>\n<!DOCTYPE Section SYSTEM \"section.dtd\">\n<Section index=\"" +
    std::to_string(index) + "\" thickness=\"0.05\" alignLocked=\"true\">\n<Transform " + transform +
    ">\n<Image mag=\"0.00254\" src=\"a.tif\"/>\n<Contour name=\"domain1\" closed=\"true\" "
    "points=\"0 0, 9 0, 9 9,\"/>\n</Transform>\n<Transform " +
    transform +
    ">\n<Contour name=\"star\" hidden=\"false\" closed=\"true\" border=\"1 0.5 0\" points=\"" +
    points + "\"/>\n" + more + "</Transform>\n</Section>\n";
}

constexpr const char* NoTransform = "dim=\"0\" xcoef=\" 0 1 0 0 0 0\" ycoef=\" 0 0 1 0 0 0\"";
constexpr const char* SeriesFile =
  "<?xml version=\"1.0\"?>\n<Series index=\"1\" units=\"microns\" "
  "defaultThickness=\"0.05\">\n<ZContour name=\"z\" points=\"0 0 1\"/>\n"
  "</Series>\n";

/// The newest layout of PyReconstruct, an object of sections with lists as traces.
constexpr const char* JSONSeries =
  "{\"sections\": {\"2\": {\"tforms\": {\"default\": [2, 0, 1, 0, 1, -1]}, \"thickness\": 0.05, "
  "\"contours\": {\"star\": [[[0, 1, 1], [0, 0, 1], [255, 128, 0], true, false, false, "
  "[\"none\", \"none\"], []]], \"line\": [[[0, 1], [0, 1], [0, 0, 9], false, false, false, [], "
  "[]]]}}}, "
  "\"series\": {\"alignment\": \"default\"}}";
}

#endif
