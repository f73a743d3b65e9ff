// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/TextScanner.h"

#include "Base/Monitor.h"
#include "Common/TextFile.h"

#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

namespace recon
{
namespace
{
constexpr std::size_t MaximumShown = 24;

bool IsSpace(char c)
{
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}

/// Control characters do not occur in text; a byte order mark and any UTF-8 do.
bool IsText(char c)
{
  const auto code = static_cast<unsigned char>(c);
  return IsSpace(c) || (code >= 0x20 && code != 0x7f);
}

std::string_view WithoutPlus(std::string_view token)
{
  return token.size() > 1 && token[0] == '+' && token[1] != '-' ? token.substr(1) : token;
}
}

std::string Quoted(std::string_view token)
{
  std::string shown(token.substr(0, MaximumShown));
  for (char& c : shown)
  {
    c = c >= ' ' && c < '\x7f' ? c : '?';
  }
  return "'" + shown + (token.size() > MaximumShown ? "...'" : "'");
}

bool ParseNumber(std::string_view token, double& value)
{
  token = WithoutPlus(token);
  const char* end = token.data() + token.size();
  const auto [stop, status] = std::from_chars(token.data(), end, value);
  // A subnormal that underflows to zero is reported as out of range; it is 0 to any user.
  if (status == std::errc::result_out_of_range && stop == end)
  {
    value = std::strtod(std::string(token).c_str(), nullptr);
    return std::isfinite(value);
  }
  return status == std::errc() && stop == end && std::isfinite(value);
}

bool ParseInteger(std::string_view token, int& value)
{
  token = WithoutPlus(token);
  const char* end = token.data() + token.size();
  const auto [stop, status] = std::from_chars(token.data(), end, value);
  return status == std::errc() && stop == end;
}

std::string ReadStart(const std::string& fileName, std::size_t bytes)
{
  std::error_code status;
  if (!std::filesystem::is_regular_file(fileName, status))
  {
    return {};
  }
  std::ifstream file(fileName, std::ios::binary);
  std::string start(bytes, '\0');
  file.read(start.data(), static_cast<std::streamsize>(bytes));
  start.resize(static_cast<std::size_t>(file.gcount()));
  return start;
}

TextScanner::TextScanner(const std::string& fileName)
  : TextScanner(fileName, ReadTextFile(fileName))
{
}

TextScanner::TextScanner(const std::string& fileName, std::string text)
  : FileName(fileName),
    Text(std::move(text))
{
  if (this->Text.compare(0, 3, "\xEF\xBB\xBF") == 0)
  {
    this->Position = 3;
  }
  int line = 1;
  for (const char c : this->Text)
  {
    line += c == '\n';
    if (!IsText(c))
    {
      this->TokenLine = line;
      this->Fail("this is a binary file, not a text file.");
    }
  }
  if (this->Peek().empty())
  {
    throw Error("Cannot read " + fileName + ": the file is empty.");
  }
}

void TextScanner::SkipSpace()
{
  while (this->Position < this->Text.size() && IsSpace(this->Text[this->Position]))
  {
    this->Line += this->Text[this->Position] == '\n';
    ++this->Position;
  }
}

std::string_view TextScanner::Peek()
{
  this->SkipSpace();
  std::size_t end = this->Position;
  while (end < this->Text.size() && !IsSpace(this->Text[end]))
  {
    ++end;
  }
  return std::string_view(this->Text).substr(this->Position, end - this->Position);
}

std::string_view TextScanner::Next(const char* expected)
{
  const std::string_view token = this->Peek();
  this->TokenLine = this->Line;
  if (token.empty())
  {
    this->Fail("expected " + std::string(expected) + ", found the end of the file.");
  }
  this->Position += token.size();
  return token;
}

double TextScanner::NextNumber(const char* expected)
{
  const std::string_view token = this->Next(expected);
  double value = 0;
  if (!ParseNumber(token, value))
  {
    this->FailExpected(expected, token);
  }
  return value;
}

int TextScanner::NextInteger(const char* expected)
{
  const std::string_view token = this->Next(expected);
  int value = 0;
  if (!ParseInteger(token, value))
  {
    this->FailExpected(expected, token);
  }
  return value;
}

int TextScanner::NextCount(const char* expected, std::size_t bytesEach)
{
  const std::string_view token = this->Next(expected);
  int count = 0;
  if (!ParseInteger(token, count) || count < 0)
  {
    this->FailExpected(expected, token);
  }
  this->CheckCount(expected, count, bytesEach);
  return count;
}

void TextScanner::CheckCount(const char* expected, int count, std::size_t bytesEach) const
{
  // The last thing of a file may lack its separator: hence one byte more.
  if (static_cast<std::size_t>(count) > (this->BytesLeft() + 1) / bytesEach)
  {
    this->Fail(std::string(expected) + " is " + std::to_string(count) +
      ", more than the rest of the file can hold; it is truncated or the count is wrong.");
  }
}

void TextScanner::ExpectEnd(const std::string& where)
{
  if (!this->AtEnd())
  {
    const std::string expected = "the end of the file " + where;
    this->FailExpected(expected.c_str(), this->Next(expected.c_str()));
  }
}

void TextScanner::Expect(const char* token, const char* expected)
{
  const std::string_view found = this->Next(expected);
  if (found != token)
  {
    this->FailExpected(expected, found);
  }
}

void TextScanner::Fail(const std::string& sentence) const
{
  throw Error("Cannot read " + this->FileName + ", line " + std::to_string(this->TokenLine) + ": " +
    sentence);
}

void TextScanner::FailExpected(const char* expected, std::string_view found) const
{
  this->Fail("expected " + std::string(expected) + ", found " + Quoted(found) + ".");
}

double TextScanner::GetFraction() const
{
  return static_cast<double>(this->Position) / static_cast<double>(this->Text.size());
}
}
