// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Text.h"

#include <algorithm>
#include <cstdio>

namespace recon
{
std::string Text(double x)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

std::string Text(const Point3& p)
{
  return "(" + Text(p[0]) + ", " + Text(p[1]) + ", " + Text(p[2]) + ")";
}

std::string Counted(std::size_t count, const std::string& noun)
{
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string Listed(const std::vector<std::string>& words, std::size_t most)
{
  const std::size_t named = std::min(words.size(), most);
  std::string text;
  for (std::size_t i = 0; i < named; ++i)
  {
    if (i > 0)
    {
      text += (i + 1 == words.size()) ? " and " : ", ";
    }
    text += words[i];
  }
  if (named < words.size())
  {
    text += " and " + std::to_string(words.size() - named) + " more";
  }
  return text;
}

std::string Listed(const std::vector<int>& numbers, std::size_t most)
{
  std::vector<std::string> words;
  words.reserve(numbers.size());
  for (int number : numbers)
  {
    words.push_back(std::to_string(number));
  }
  return Listed(words, most);
}
}
