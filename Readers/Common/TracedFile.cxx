// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/TracedFile.h"

#include "Base/Monitor.h"
#include "Base/Text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace recon
{
namespace
{
constexpr std::size_t LongestName = 200; // bytes; names of a person are far shorter

bool IsFinite(const Point3& p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

unsigned char Byte(std::string_view bytes, std::size_t i)
{
  return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0;
}

/// How many bytes of UTF-8 (RFC 3629) begin here; 0 where none do.
std::size_t LengthOfLetter(std::string_view bytes, std::size_t at)
{
  const unsigned char first = Byte(bytes, at);
  if (first < 0x80)
  {
    return 1;
  }
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4)
  {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i)
  {
    if ((Byte(bytes, at + i) & 0xc0) != 0x80)
    {
      return 0;
    }
  }
  const unsigned char second = Byte(bytes, at + 1);
  const bool isLong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool isNoLetter = (first == 0xed && second > 0x9f) || (first == 0xf4 && second > 0x8f);
  return isLong || isNoLetter ? 0 : length;
}

void AppendLatin1(std::string& text, unsigned char code)
{
  text += static_cast<char>(0xc0 | (code >> 6));
  text += static_cast<char>(0x80 | (code & 0x3f));
}

std::string Trimmed(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of(' ');
  return begin == std::string::npos ? ""
                                    : text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}
}

std::string CleanName(std::string_view bytes)
{
  std::string name;
  for (std::size_t i = 0; i < bytes.size() && name.size() < LongestName;)
  {
    const std::size_t length = LengthOfLetter(bytes, i);
    if (length == 0)
    {
      const unsigned char code = Byte(bytes, i++);
      // The control characters of Latin-1 are nothing to show either.
      code < 0xa0 ? void(name += ' ') : AppendLatin1(name, code);
      continue;
    }
    const bool isControl = length == 1 && (Byte(bytes, i) < 0x20 || Byte(bytes, i) == 0x7f);
    name += isControl ? " " : std::string(bytes.substr(i, length));
    i += length;
  }
  name = Trimmed(name);
  return name.empty() ? "unnamed" : name;
}

TracedObject& TraceCollector::Named(std::string_view name)
{
  const std::string clean = CleanName(name);
  const auto [found, isNew] = this->Numbers.emplace(clean, this->File.Objects.size());
  if (isNew)
  {
    this->File.Objects.emplace_back();
    this->File.Objects.back().Name = clean;
  }
  return this->File.Objects[found->second];
}

void TraceCollector::SetColor(TracedObject& object, const std::array<unsigned char, 3>& color)
{
  if (!object.HasColor)
  {
    object.HasColor = true;
    object.Color = color;
  }
}

void TraceCollector::Add(TracedObject& object, const std::vector<Point3>& points, bool closed,
  int slice, const std::string& name)
{
  if (points.empty())
  {
    ++this->WithoutPoints;
    return;
  }
  if (!std::all_of(points.begin(), points.end(), IsFinite))
  {
    ++this->NotFinite;
    return;
  }
  object.Soup.Append(points, closed && points.size() > 1);
  object.Slices.push_back(slice);
  if (!name.empty() || !object.Names.empty())
  {
    object.Names.resize(object.Soup.Chains.size());
    object.Names.back() = name.empty() ? name : CleanName(name);
  }
}

TracedFile TraceCollector::Take(const std::string& fileName)
{
  auto& objects = this->File.Objects;
  const bool isEmpty = std::all_of(objects.begin(), objects.end(),
    [](const TracedObject& object) { return object.Soup.Chains.empty(); });
  if (isEmpty)
  {
    throw Error("Cannot read " + fileName + ": it holds no contours.");
  }
  if (this->WithoutPoints > 0)
  {
    this->Say(Counted(static_cast<std::size_t>(this->WithoutPoints), "trace") +
      " without any point: left out.");
  }
  if (this->NotFinite > 0)
  {
    this->Say(Counted(static_cast<std::size_t>(this->NotFinite), "trace") +
      " with coordinates that are no finite numbers: left out.");
  }
  return std::move(this->File);
}
}
