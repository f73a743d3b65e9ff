// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/RegionFiles.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <set>

namespace recon
{
namespace
{
/// Bytes of a region's name in a file's: file systems take 255 in all.
constexpr std::size_t LongestName = 100;

bool IsAscii(char c)
{
  return static_cast<unsigned char>(c) < 0x80;
}

/// Bytes beyond ASCII are part of a letter of another alphabet, in UTF-8.
bool IsKept(char c)
{
  return !IsAscii(c) || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
    (c >= 'A' && c <= 'Z') || c == '.' || c == '_' || c == '-';
}

/// Never half a letter: a byte of the form 10xxxxxx goes on with one.
std::string Cut(std::string text, std::size_t most)
{
  if (text.size() <= most)
  {
    return text;
  }
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80)
  {
    --most;
  }
  text.resize(most);
  return text;
}

std::string InFileName(const std::string& region)
{
  std::string name;
  for (const char c : region)
  {
    if (IsKept(c))
    {
      name += c;
    }
    else if (!name.empty() && name.back() != '_')
    {
      name += '_';
    }
  }
  name = Cut(name, LongestName);
  const std::size_t first = name.find_first_not_of("._");
  const std::size_t last = name.find_last_not_of("._");
  return first == std::string::npos ? "ROI" : name.substr(first, last - first + 1);
}

/// Without regard to case, as some file systems see it.
std::string Folded(std::string name)
{
  std::transform(name.begin(), name.end(), name.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return name;
}
}

std::vector<std::string> RegionFileNames(
  const std::string& path, const std::vector<std::string>& regions)
{
  if (regions.size() == 1)
  {
    return { path };
  }
  const std::filesystem::path whole(path);
  const std::string stem = (whole.parent_path() / whole.stem()).string();
  std::vector<std::string> files;
  std::set<std::string> taken;
  for (std::size_t r = 0; r < regions.size(); ++r)
  {
    const std::string plain = InFileName(regions[r]);
    std::string name = plain;
    for (std::size_t number = r + 1; !taken.insert(Folded(name)).second; ++number)
    {
      name = plain + "-" + std::to_string(number);
    }
    files.push_back(stem + "-" + name + whole.extension().string());
  }
  return files;
}
}
