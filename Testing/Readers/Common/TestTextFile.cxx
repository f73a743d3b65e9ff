// SPDX-License-Identifier: GPL-3.0-or-later
#include "Readers/ReaderTesting.h"

#include "Common/TextFile.h"

#include <cmath>
#include <cstring>
#include <limits>

using namespace readertesting;

namespace
{
class TextFile : public Folder
{
};

std::string Number(double value)
{
  std::string text;
  recon::AppendNumber(text, value);
  return text;
}
}

TEST_F(TextFile, IsReadAsItWasWritten)
{
  const std::string text("lines\r\n\0and \xff bytes\n", 20);
  recon::WriteTextFile(this->Name("a"), text);
  EXPECT_EQ(recon::ReadTextFile(this->Name("a")), text);
  recon::WriteTextFile(this->Name("a"), "");
  EXPECT_EQ(recon::ReadTextFile(this->Name("a")), "");
}

TEST_F(TextFile, WhatCannotBeReadOrWrittenIsASentence)
{
  ExpectSentence(
    SentenceOf([&] { recon::ReadTextFile(this->Name("absent")); }), "absent", "no such file");
  ExpectSentence(SentenceOf([&] { recon::ReadTextFile(this->Name("")); }), "", "no such file");
  ExpectSentence(
    SentenceOf([&] { recon::WriteTextFile(this->Name("none/a"), "text"); }), "none/a", "no folder");
}

TEST(AppendNumber, FewestDigitsThatGiveTheSameNumberAgain)
{
  EXPECT_EQ(Number(0.1), "0.1");
  EXPECT_EQ(Number(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(Number(-0.0), "-0");
  EXPECT_EQ(Number(1e300), "1e+300");
  std::mt19937_64 random(1);
  for (int i = 0; i < 10000; ++i)
  {
    const std::uint64_t bits = random();
    double value = 0;
    std::memcpy(&value, &bits, sizeof(value));
    if (std::isfinite(value))
    {
      EXPECT_EQ(std::strtod(Number(value).c_str(), nullptr), value);
    }
  }
}
