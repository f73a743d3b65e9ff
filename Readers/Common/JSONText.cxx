// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/JSONText.h"

#include "Common/TextScanner.h"

#include <algorithm>
#include <string_view>

namespace recon
{
namespace
{
constexpr int DeepestNesting = 64; // the formats read here have six; a bound for the stack
constexpr std::size_t ValuesAnUpdate = 1 << 14;

void AppendUTF8(std::string& text, unsigned int code)
{
  const auto append = [&text](unsigned int byte) { text += static_cast<char>(byte); };
  if (code < 0x80)
  {
    append(code);
    return;
  }
  if (code < 0x800)
  {
    append(0xc0 | (code >> 6));
  }
  else if (code < 0x10000)
  {
    append(0xe0 | (code >> 12));
    append(0x80 | ((code >> 6) & 0x3f));
  }
  else
  {
    append(0xf0 | (code >> 18));
    append(0x80 | ((code >> 12) & 0x3f));
    append(0x80 | ((code >> 6) & 0x3f));
  }
  append(0x80 | (code & 0x3f));
}

class Parser
{
public:
  Parser(const std::string& fileName, const std::string& text, Monitor& monitor)
    : FileName(fileName),
      Text(text),
      Progress(monitor)
  {
    if (this->Text.substr(0, 3) == "\xEF\xBB\xBF")
    {
      this->Position = 3;
    }
  }

  JSONValue Read()
  {
    JSONValue value = this->Value(0);
    this->SkipSpace();
    if (this->Position < this->Text.size())
    {
      this->FailExpected("the end of the file");
    }
    return value;
  }

private:
  JSONValue Value(int depth)
  {
    if (++this->Values % ValuesAnUpdate == 0)
    {
      this->Progress.Update(
        static_cast<double>(this->Position) / static_cast<double>(this->Text.size()), "reading");
    }
    if (depth > DeepestNesting)
    {
      this->Fail("it is nested more than " + std::to_string(DeepestNesting) + " deep.");
    }
    this->SkipSpace();
    JSONValue value;
    switch (this->Peek())
    {
      case '{':
        this->ReadObject(value, depth);
        break;
      case '[':
        this->ReadList(value, depth);
        break;
      case '"':
        value.Type = JSONValue::Kind::String;
        value.String = this->QuotedString();
        break;
      default:
        this->ReadWord(value);
    }
    return value;
  }

  void ReadObject(JSONValue& value, int depth)
  {
    value.Type = JSONValue::Kind::Object;
    ++this->Position;
    while (!this->Closes('}', value.Pairs.empty()))
    {
      this->SkipSpace();
      if (this->Peek() != '"')
      {
        this->FailExpected("a name in quotes");
      }
      std::string name = this->QuotedString();
      this->SkipSpace();
      if (this->Peek() != ':')
      {
        this->FailExpected("':'");
      }
      ++this->Position;
      value.Pairs.emplace_back(std::move(name), this->Value(depth + 1));
    }
  }

  void ReadList(JSONValue& value, int depth)
  {
    value.Type = JSONValue::Kind::List;
    ++this->Position;
    while (!this->Closes(']', value.Items.empty() && value.Numbers.empty()))
    {
      JSONValue item = this->Value(depth + 1);
      if (item.IsNumber() && value.Items.empty())
      {
        value.Numbers.push_back(item.Number);
        continue;
      }
      MakeMixed(value);
      value.Items.push_back(std::move(item));
    }
  }

  /// What began as a list of numbers has something else in it.
  static void MakeMixed(JSONValue& list)
  {
    for (const double number : list.Numbers)
    {
      JSONValue item;
      item.Type = JSONValue::Kind::Number;
      item.Number = number;
      list.Items.push_back(std::move(item));
    }
    list.Numbers.clear();
  }

  /// Takes the end of a list or an object, or the comma before its next item.
  bool Closes(char end, bool isFirst)
  {
    this->SkipSpace();
    if (this->Peek() == end)
    {
      ++this->Position;
      return true;
    }
    if (!isFirst)
    {
      if (this->Peek() != ',')
      {
        this->FailExpected(end == ']' ? "',' or ']'" : "',' or '}'");
      }
      ++this->Position;
    }
    return false;
  }

  void ReadWord(JSONValue& value)
  {
    const std::size_t end =
      std::min(this->Text.find_first_of(" \t\r\n,]}:\"", this->Position), this->Text.size());
    const std::string_view word = this->Text.substr(this->Position, end - this->Position);
    if (word == "true" || word == "false")
    {
      value.Type = JSONValue::Kind::Boolean;
      value.Boolean = word == "true";
    }
    else if (word != "null")
    {
      value.Type = JSONValue::Kind::Number;
      if (!ParseNumber(word, value.Number))
      {
        this->FailExpected("a value");
      }
    }
    this->Position = end;
  }

  std::string QuotedString()
  {
    std::string text;
    ++this->Position;
    while (this->Peek() != '"')
    {
      if (this->Position >= this->Text.size())
      {
        this->Fail("a text in quotes does not end; the file is truncated.");
      }
      if (this->Peek() == '\\')
      {
        this->AppendEscape(text);
        continue;
      }
      text += this->Text[this->Position++];
    }
    ++this->Position;
    return text;
  }

  void AppendEscape(std::string& text)
  {
    static constexpr std::string_view letters = "\"\\/bfnrt";
    static constexpr std::string_view meanings = "\"\\/\b\f\n\r\t";
    ++this->Position;
    const std::size_t known = letters.find(this->Peek());
    if (known != std::string_view::npos && this->Peek() != '\0')
    {
      text += meanings[known];
      ++this->Position;
      return;
    }
    if (this->Peek() != 'u')
    {
      this->FailExpected("a letter that may follow a backslash");
    }
    unsigned int code = this->HexDigits();
    if (code >= 0xd800 && code < 0xdc00 && this->Text.substr(this->Position, 2) == "\\u")
    {
      ++this->Position;
      code = 0x10000 + ((code - 0xd800) << 10) + ((this->HexDigits() - 0xdc00) & 0x3ff);
    }
    const bool isHalf = code >= 0xd800 && code < 0xe000;
    AppendUTF8(text, isHalf ? 0xfffd : code);
  }

  /// The four behind a 'u'.
  unsigned int HexDigits()
  {
    unsigned int code = 0;
    for (std::size_t i = 0; i < 4; ++i)
    {
      ++this->Position;
      const std::size_t digit = std::string_view("0123456789abcdef").find(Lower(this->Peek()));
      if (digit == std::string_view::npos || this->Peek() == '\0')
      {
        this->FailExpected("four hexadecimal digits");
      }
      code = 16 * code + static_cast<unsigned int>(digit);
    }
    ++this->Position;
    return code;
  }

  static char Lower(char c) { return c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c; }

  char Peek() const
  {
    return this->Position < this->Text.size() ? this->Text[this->Position] : '\0';
  }

  void SkipSpace()
  {
    while (this->Position < this->Text.size() &&
      std::string_view(" \t\r\n").find(this->Text[this->Position]) != std::string_view::npos)
    {
      ++this->Position;
    }
  }

  [[noreturn]] void FailExpected(const std::string& expected) const
  {
    const bool atEnd = this->Position >= this->Text.size();
    this->Fail("expected " + expected + ", found " +
      (atEnd ? "the end of the file" : Quoted(this->Text.substr(this->Position, 1))) + ".");
  }

  [[noreturn]] void Fail(const std::string& sentence) const
  {
    const std::string_view before = this->Text.substr(0, this->Position);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    throw Error("Cannot read " + this->FileName + ", line " + std::to_string(line) + ", byte " +
      std::to_string(this->Position) + ": " + sentence);
  }

  std::string FileName;
  std::string_view Text;
  Monitor& Progress;
  std::size_t Position = 0;
  std::size_t Values = 0;
};
}

const JSONValue* JSONValue::Find(const std::string& name) const
{
  const auto found = std::find_if(this->Pairs.begin(), this->Pairs.end(),
    [&name](const auto& pair) { return pair.first == name; });
  return found == this->Pairs.end() ? nullptr : &found->second;
}

JSONValue ReadJSON(const std::string& fileName, const std::string& text, Monitor& monitor)
{
  return Parser(fileName, text, monitor).Read();
}
}
