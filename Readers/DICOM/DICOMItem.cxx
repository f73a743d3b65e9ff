// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/DICOMItem.h"

#include "Base/Monitor.h"

#include <dcmtk/dcmdata/dcuid.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>

namespace recon
{
namespace
{
/// The text of an item's contour data, trimmed and empty where there is none; whether it can be
/// read.
bool GetContourText(DcmItem& contour, std::string_view& data)
{
  DcmElement* element = nullptr;
  if (contour.findAndGetElement(DCM_ContourData, element).bad() || !element)
  {
    return true;
  }
  // Explicit VR has 16 bits for the length of a DS; longer ones are written as UN.
  if (element->ident() == EVR_UN || element->ident() == EVR_OB)
  {
    Uint8* bytes = nullptr;
    if (element->getUint8Array(bytes).bad())
    {
      return false;
    }
    if (bytes)
    {
      data = Trimmed(std::string_view(reinterpret_cast<const char*>(bytes), element->getLength()));
    }
    return true;
  }
  char* text = nullptr;
  Uint32 length = 0;
  if (element->getString(text, length).bad())
  {
    return false;
  }
  if (text)
  {
    data = Trimmed(std::string_view(text, length));
  }
  return true;
}

std::string_view WithoutLastBackslashes(std::string_view text)
{
  while (!text.empty() && text.back() == '\\')
  {
    text.remove_suffix(1);
    text = Trimmed(text);
  }
  return text;
}
}

std::string TagName(const DcmTagKey& key)
{
  DcmTag tag(key);
  return std::string(tag.getTagName()) + " " + key.toString().c_str();
}

std::string_view Trimmed(std::string_view text)
{
  // DICOM pads with a space, some writers with a NUL.
  const auto isPadding = [](char c) { return c == ' ' || c == '\0' || c == '\r' || c == '\n'; };
  while (!text.empty() && isPadding(text.front()))
  {
    text.remove_prefix(1);
  }
  while (!text.empty() && isPadding(text.back()))
  {
    text.remove_suffix(1);
  }
  return text;
}

std::string GetText(DcmItem& item, const DcmTagKey& key)
{
  OFString value;
  if (item.findAndGetOFStringArray(key, value).bad())
  {
    return {};
  }
  return std::string(Trimmed(std::string_view(value.c_str(), value.size())));
}

std::string GetUID(DcmItem& item, const DcmTagKey& key)
{
  constexpr std::size_t longest = 64; // PS3.5 9.1
  std::string uid = GetText(item, key).substr(0, longest);
  std::replace_if(
    uid.begin(), uid.end(), [](char c) { return c != '.' && (c < '0' || c > '9'); }, '?');
  return uid;
}

bool GetNumber(DcmItem& item, const DcmTagKey& key, int& value)
{
  return ParseInteger(GetText(item, key), value);
}

bool GetNumber(DcmItem& item, const DcmTagKey& key, unsigned long index, double& value)
{
  OFString text;
  return item.findAndGetOFString(key, text, index).good() &&
    ParseNumber(Trimmed(std::string_view(text.c_str(), text.size())), value);
}

std::vector<DcmItem*> ItemsOf(DcmSequenceOfItems& sequence)
{
  std::vector<DcmItem*> items;
  for (DcmObject* object = sequence.nextInContainer(nullptr); object;
       object = sequence.nextInContainer(object))
  {
    if (auto* item = dynamic_cast<DcmItem*>(object))
    {
      items.push_back(item);
    }
  }
  return items;
}

std::vector<DcmItem*> ItemsOf(DcmItem& item, const DcmTagKey& key)
{
  DcmElement* element = nullptr;
  if (item.findAndGetElement(key, element).bad())
  {
    return {};
  }
  auto* sequence = dynamic_cast<DcmSequenceOfItems*>(element);
  return sequence ? ItemsOf(*sequence) : std::vector<DcmItem*>();
}

bool BeginsAsDICOM(const std::string& fileName)
{
  constexpr std::size_t preamble = 128;
  const std::string start = ReadStart(fileName, preamble + 4);
  if (start.compare(std::min(preamble, start.size()), 4, "DICM") == 0)
  {
    return true;
  }
  // Without preamble: the first element is one of the group 2 or 8, of either byte order.
  const auto isGroup = [&start](std::size_t low, std::size_t high)
  { return (start[low] == 2 || start[low] == 8) && start[high] == 0; };
  return start.size() >= 8 && (isGroup(0, 1) || isGroup(1, 0));
}

std::string ClassName(const std::string& uid)
{
  const char* name = dcmFindNameOfUID(uid.c_str());
  return name ? name : uid;
}

ContourPoints GetContourPoints(DcmItem& contour)
{
  ContourPoints result;
  std::string_view data;
  if (!GetContourText(contour, data))
  {
    result.Fault = TagName(DCM_ContourData) + " cannot be read to its end";
    return result;
  }
  data = WithoutLastBackslashes(data);
  if (data.empty())
  {
    return result;
  }
  Point3 point{};
  std::size_t values = 0;
  ForEachValue(data,
    [&](std::string_view text)
    {
      double value = 0;
      if (!ParseNumber(text, value) && result.Fault.empty())
      {
        result.HasNumbers = false;
        result.Fault = "expected a number as value " + std::to_string(values + 1) + " of " +
          TagName(DCM_ContourData) + ", found " + Quoted(text);
      }
      point[values % 3] = value;
      if (++values % 3 == 0)
      {
        result.Points.push_back(point);
      }
    });
  if (values % 3 != 0 && result.Fault.empty())
  {
    result.Fault = "expected three coordinates a point in " + TagName(DCM_ContourData) +
      ", found " + std::to_string(values) + " numbers";
  }
  if (!result.Fault.empty())
  {
    result.Points.clear();
  }
  return result;
}

void Put(DcmItem& item, const DcmTagKey& key, const std::string& value)
{
  const OFCondition condition = item.putAndInsertString(key, value.c_str());
  if (condition.bad())
  {
    throw Error("Cannot set " + TagName(key) + " (DCMTK says: " + condition.text() + ").");
  }
}

void CopyElement(DcmItem& from, const DcmTagKey& key, DcmItem& to)
{
  DcmElement* copy = nullptr;
  if (from.findAndGetElement(key, copy, OFFalse, OFTrue).bad() || !copy)
  {
    return;
  }
  const OFCondition condition = to.insert(copy, OFTrue);
  if (condition.bad())
  {
    delete copy;
    throw Error("Cannot copy " + TagName(key) + " (DCMTK says: " + condition.text() + ").");
  }
}

DcmItem& AppendItem(DcmItem& parent, const DcmTagKey& sequence)
{
  constexpr signed long append = -2;
  DcmItem* item = nullptr;
  const OFCondition condition = parent.findOrCreateSequenceItem(sequence, item, append);
  if (condition.bad())
  {
    throw Error("Cannot add to " + TagName(sequence) + " (DCMTK says: " + condition.text() + ").");
  }
  return *item;
}

std::string NewUID()
{
  // 128 random bits, of which a version 4 UUID fixes six.
  std::random_device random;
  std::array<std::uint32_t, 4> words{ random(), random(), random(), random() };
  words[1] = (words[1] & 0xffff0fffU) | 0x00004000U;
  words[2] = (words[2] & 0x3fffffffU) | 0x80000000U;
  std::string digits;
  while (std::any_of(words.begin(), words.end(), [](std::uint32_t word) { return word != 0; }))
  {
    std::uint64_t remainder = 0;
    for (std::uint32_t& word : words)
    {
      const std::uint64_t dividend = (remainder << 32) | word;
      word = static_cast<std::uint32_t>(dividend / 10);
      remainder = dividend % 10;
    }
    digits.insert(digits.begin(), static_cast<char>('0' + remainder));
  }
  return "2.25." + digits;
}
}
