// SPDX-License-Identifier: GPL-3.0-or-later
#include "Table/TableColumns.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>

namespace recon
{
namespace
{
constexpr const char* KnownUnits[] = { "mm", "cm", "m", "um", "nm" };

bool IsSpace(char c)
{
  return c == ' ' || c == '\t' || c == '\r';
}

std::string_view Trimmed(std::string_view word)
{
  while (!word.empty() && IsSpace(word.front()))
  {
    word.remove_prefix(1);
  }
  while (!word.empty() && IsSpace(word.back()))
  {
    word.remove_suffix(1);
  }
  return word;
}

/// Letters and digits in lower case; all else separates, as in "X_um" and "Contour ID".
std::vector<std::string> PartsOf(const std::string& name)
{
  std::vector<std::string> parts(1);
  for (const char c : name)
  {
    const auto code = static_cast<unsigned char>(c);
    if (std::isalnum(code))
    {
      parts.back() += static_cast<char>(std::tolower(code));
    }
    else if (!parts.back().empty())
    {
      parts.emplace_back();
    }
  }
  if (parts.back().empty() && parts.size() > 1)
  {
    parts.pop_back();
  }
  return parts;
}

bool IsOneOf(const std::string& word, std::initializer_list<const char*> words)
{
  return std::any_of(words.begin(), words.end(), [&](const char* known) { return word == known; });
}
}

char SeparatorOf(std::string_view line)
{
  for (const char separator : { '\t', ';', ',' })
  {
    if (line.find(separator) != std::string_view::npos)
    {
      return separator;
    }
  }
  return ' ';
}

std::vector<std::string> SplitRow(std::string_view line, char separator)
{
  std::vector<std::string> words(1);
  bool isQuoted = false;
  for (const char c : Trimmed(line))
  {
    if (c == '"')
    {
      isQuoted = !isQuoted;
    }
    else if (!isQuoted && (c == separator || (separator == ' ' && IsSpace(c))))
    {
      words.emplace_back();
    }
    else
    {
      words.back() += c;
    }
  }
  for (std::string& word : words)
  {
    word = std::string(Trimmed(word));
  }
  if (separator == ' ')
  {
    words.erase(std::remove(words.begin(), words.end(), std::string()), words.end());
  }
  return words;
}

TableColumns TableColumns::Named(const std::vector<std::string>& names)
{
  TableColumns columns;
  const auto take = [](int& column, int number) { column = column < 0 ? number : column; };
  for (int i = 0; i < static_cast<int>(names.size()); ++i)
  {
    const std::vector<std::string> parts = PartsOf(names[static_cast<std::size_t>(i)]);
    const std::string& word = parts.front();
    if (IsOneOf(word, { "x", "y", "z" }))
    {
      take(word == "x" ? columns.X : word == "y" ? columns.Y : columns.Z, i);
      const std::string unit = parts.size() > 1 ? parts.back() : "";
      const bool isKnown = std::any_of(std::begin(KnownUnits), std::end(KnownUnits),
        [&](const char* known) { return unit == known; });
      columns.LengthUnit = isKnown && word == "x" ? unit : columns.LengthUnit;
    }
    else if (IsOneOf(word, { "slice", "section", "plane", "level", "frame" }))
    {
      take(columns.Slice, i);
    }
    else if (IsOneOf(
               word, { "contour", "contourid", "loop", "polygon", "polyline", "curve", "id" }))
    {
      take(columns.Contour, i);
    }
    else if (IsOneOf(word,
               { "object", "name", "label", "structure", "roi", "region", "material", "layer" }))
    {
      take(columns.Object, i);
    }
  }
  return columns;
}

TableColumns TableColumns::Counted(std::size_t columns)
{
  TableColumns counted;
  const auto at = [columns](int column)
  { return static_cast<std::size_t>(column) < columns ? column : -1; };
  counted.X = at(0);
  counted.Y = at(1);
  counted.Z = at(2);
  counted.Contour = at(3);
  counted.Slice = at(4);
  return counted;
}
}
