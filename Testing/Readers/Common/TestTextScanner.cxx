// SPDX-License-Identifier: GPL-3.0-or-later
#include "Readers/ReaderTesting.h"

#include "Common/TextScanner.h"

using namespace readertesting;
using recon::TextScanner;

namespace
{
/// The sentence that an action on a scanner of this text ends in.
template <typename Action>
std::string After(const std::string& text, Action action)
{
  return SentenceOf(
    [&]
    {
      TextScanner scanner("a file", text);
      action(scanner);
    });
}
}

TEST(TextScanner, TokensWithTheirLines)
{
  TextScanner scanner("a file", "\xEF\xBB\xBF one\ttwo\r\n\r\n3 4.5e1\n");
  EXPECT_EQ(scanner.Next("a word"), "one");
  EXPECT_EQ(scanner.GetLine(), 1);
  EXPECT_EQ(scanner.Peek(), "two");
  scanner.Expect("two", "the word two");
  EXPECT_EQ(scanner.NextInteger("a number"), 3);
  EXPECT_EQ(scanner.GetLine(), 3);
  EXPECT_LT(scanner.GetFraction(), 1);
  EXPECT_EQ(scanner.NextNumber("a number"), 45);
  EXPECT_TRUE(scanner.AtEnd());
  scanner.ExpectEnd("after all");
  EXPECT_EQ(scanner.GetFraction(), 1);
}

TEST(TextScanner, WhatIsNotExpectedIsASentence)
{
  ExpectSentence(
    After("1\ntwo", [](TextScanner& s) { s.NextNumber("one"), s.NextNumber("a two"); }),
    "a file, line 2", "expected a two, found 'two'");
  ExpectSentence(After("1", [](TextScanner& s) { s.NextNumber("one"), s.NextNumber("more"); }),
    "a file", "expected more, found the end of the file");
  ExpectSentence(
    After("1 2", [](TextScanner& s) { s.NextNumber("one"), s.ExpectEnd("after one"); }), "a file",
    "expected the end of the file after one, found '2'");
  ExpectSentence(After("nan", [](TextScanner& s) { s.NextNumber("a number"); }), "a file", "'nan'");
  ExpectSentence(After("1.5", [](TextScanner& s) { s.NextInteger("a count"); }), "a file", "'1.5'");
  ExpectSentence(After("-1", [](TextScanner& s) { s.NextCount("a count", 1); }), "a file", "'-1'");
  ExpectSentence(After(" \n", [](TextScanner&) {}), "a file", "the file is empty");
  ExpectSentence(After("a\nb\x01", [](TextScanner&) {}), "a file, line 2", "a binary file");
}

TEST(TextScanner, CountsThatTheRestCannotHoldAreRefused)
{
  EXPECT_TRUE(After("3 a b c", [](TextScanner& s) { s.NextCount("the count", 2); }).empty());
  ExpectSentence(After("4 a b c", [](TextScanner& s) { s.NextCount("the count", 2); }), "a file",
    "the count is 4, more than the rest of the file can hold");
}

TEST(ParseNumber, IsOfTheWholeTokenAndFinite)
{
  double value = 0;
  for (const auto& [token, expected] : { std::pair<const char*, double>{ "+1", 1 }, { "1.", 1 },
         { ".5", 0.5 }, { "-1E3", -1000 }, { "1e-400", 0 } })
  {
    EXPECT_TRUE(recon::ParseNumber(token, value)) << token;
    EXPECT_EQ(value, expected) << token;
  }
  for (const char* token : { "", "+", "+-1", "1 ", "1,5", "0x1", "inf", "nan", "1e999", "1e" })
  {
    EXPECT_FALSE(recon::ParseNumber(token, value)) << token;
  }
}

TEST(ParseInteger, FitsAnInt)
{
  int value = 0;
  EXPECT_TRUE(recon::ParseInteger("+2147483647", value));
  EXPECT_EQ(value, 2147483647);
  for (const char* token : { "", "2147483648", "1.0", "1e1", "0x1" })
  {
    EXPECT_FALSE(recon::ParseInteger(token, value)) << token;
  }
}

TEST(Quoted, IsShortAndPrintable)
{
  EXPECT_EQ(recon::Quoted("abc"), "'abc'");
  EXPECT_EQ(recon::Quoted("a\n\xc3\xbc"), "'a???'");
  EXPECT_EQ(recon::Quoted(std::string(30, 'x')), "'" + std::string(24, 'x') + "...'");
}

using TextScannerFolder = Folder;

TEST_F(TextScannerFolder, ReadStartOfAnyFile)
{
  EXPECT_EQ(recon::ReadStart(this->Write("a", "abcdef"), 3), "abc");
  EXPECT_EQ(recon::ReadStart(this->Write("a", "ab"), 3), "ab");
  EXPECT_EQ(recon::ReadStart(this->Name("absent"), 3), "");
  EXPECT_EQ(recon::ReadStart(this->Name(""), 3), "");
}
