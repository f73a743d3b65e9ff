// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/DICOMText.h"

#include <algorithm>

namespace recon
{
namespace
{
unsigned char ByteAt(std::string_view text, std::size_t i)
{
  return static_cast<unsigned char>(text[i]);
}

/// Bytes of the character that begins at i; 0 where none does (RFC 3629).
std::size_t CharacterLength(std::string_view text, std::size_t i)
{
  const unsigned char first = ByteAt(text, i);
  if (first < 0x80)
  {
    return 1;
  }
  const std::size_t length = first >= 0xc2 && first < 0xe0 ? 2
    : first >= 0xe0 && first < 0xf0                        ? 3
    : first >= 0xf0 && first < 0xf5                        ? 4
                                                           : 0;
  if (length == 0 || i + length > text.size())
  {
    return 0;
  }
  const unsigned char second = ByteAt(text, i + 1);
  // Overlong forms, surrogates and what is beyond Unicode.
  if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
    (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f))
  {
    return 0;
  }
  for (std::size_t k = 1; k < length; ++k)
  {
    if ((ByteAt(text, i + k) & 0xc0) != 0x80)
    {
      return 0;
    }
  }
  return length;
}

std::string WithoutOuterSpaces(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? std::string()
                                    : text.substr(first, text.find_last_not_of(' ') - first + 1);
}
}

bool IsASCII(std::string_view text)
{
  return std::all_of(
    text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

bool IsUTF8(std::string_view text)
{
  std::size_t i = 0;
  while (i < text.size())
  {
    const std::size_t length = CharacterLength(text, i);
    if (length == 0)
    {
      return false;
    }
    i += length;
  }
  return true;
}

std::string DICOMText(const std::string& text, std::size_t longest)
{
  const std::string from = WithoutOuterSpaces(text);
  std::string to;
  std::size_t i = 0;
  for (std::size_t count = 0; i < from.size() && count < longest; ++count)
  {
    const std::size_t length = CharacterLength(from, i);
    const unsigned char c = ByteAt(from, i);
    if (length == 0 || c < 0x20 || c == 0x7f || c == '\\')
    {
      to += '_';
      ++i;
      continue;
    }
    to.append(from, i, length);
    i += length;
  }
  return WithoutOuterSpaces(to);
}

std::string CodeString(const std::string& text)
{
  constexpr std::size_t longest = 16;
  std::string code = WithoutOuterSpaces(text).substr(0, longest);
  for (char& c : code)
  {
    if (c >= 'a' && c <= 'z')
    {
      c = static_cast<char>(c - 'a' + 'A');
    }
    const bool isAllowed = (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ' || c == '_';
    c = isAllowed ? c : '_';
  }
  return WithoutOuterSpaces(code);
}
}
