// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file TextScanner.h
 * @brief A text file as a stream of tokens, with errors that name file and line.
 *
 * What the text readers share: whitespace-separated tokens, any line ending, numbers that
 * do not depend on the user's locale, and counts that are checked against the bytes that are left
 * before anybody allocates for them.
 */
#ifndef recon_TextScanner_h
#define recon_TextScanner_h

#include <cstddef>
#include <string>
#include <string_view>

namespace recon
{
class TextScanner
{
public:
  /// @throws Error where the file cannot be opened, is empty or is not text.
  explicit TextScanner(const std::string& fileName);
  /// For formats with comments or punctuation, which the caller has turned into spaces and tokens:
  /// text is the file's, line by line. @throws Error where it is empty or is not text.
  TextScanner(const std::string& fileName, std::string text);

  /// The next token, or an empty view at the end of the file.
  std::string_view Peek();
  /// @throws Error at the end of the file. expected completes "expected ...".
  std::string_view Next(const char* expected);
  bool AtEnd() { return this->Peek().empty(); }

  /// A finite number.
  double NextNumber(const char* expected);
  /// A whole number that fits an int.
  int NextInteger(const char* expected);
  /// A count of things that take at least bytesEach bytes of file each, separators included.
  int NextCount(const char* expected, std::size_t bytesEach);
  /// The same check for a count that the caller has read.
  void CheckCount(const char* expected, int count, std::size_t bytesEach) const;
  /// Nothing may follow; where completes "expected the end of the file ...".
  void ExpectEnd(const std::string& where);
  /// The token and nothing else.
  void Expect(const char* token, const char* expected);

  /// For tokens that the caller takes apart: the file, the line of the last token, what was
  /// expected.
  [[noreturn]] void Fail(const std::string& sentence) const;
  [[noreturn]] void FailExpected(const char* expected, std::string_view found) const;

  /// What Next took last starts at this line (1-based).
  int GetLine() const { return this->TokenLine; }
  /// Read so far, in [0, 1].
  double GetFraction() const;
  const std::string& GetFileName() const { return this->FileName; }

private:
  void SkipSpace();
  std::size_t BytesLeft() const { return this->Text.size() - this->Position; }

  std::string FileName;
  std::string Text;
  std::size_t Position = 0;
  int Line = 1;
  int TokenLine = 1;
};

/// A finite double from the whole of a token ("+1", "1.", ".5", "1e3"), whatever the locale.
bool ParseNumber(std::string_view token, double& value);
/// An int from the whole of a token.
bool ParseInteger(std::string_view token, int& value);

/// A token in a message: short, printable, in quotes.
std::string Quoted(std::string_view token);

/// The first bytes of a file, none where it cannot be read; for telling formats apart.
std::string ReadStart(const std::string& fileName, std::size_t bytes);
}

#endif
