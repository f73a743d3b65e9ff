// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/DICOMCharacterSet.h"
#include "DICOM/DICOMText.h"

#include <gtest/gtest.h>

#include <random>

using recon::DecodedText;
using recon::DICOMCharacterSet;

namespace
{
struct Example
{
  const char* Name;
  const char* Terms;
  std::string Bytes;
  const char* Text;
};

/// The name of the test is that of the example.
void PrintTo(const Example& example, std::ostream* os)
{
  *os << example.Name;
}

class Examples : public testing::TestWithParam<Example>
{
};
}

TEST_P(Examples, AreDecoded)
{
  const DecodedText decoded =
    DICOMCharacterSet(GetParam().Terms).Decode(GetParam().Bytes, /*isPersonName=*/true);
  EXPECT_EQ(decoded.Text, GetParam().Text);
  EXPECT_EQ(decoded.Outcome, DecodedText::How::Explained);
}

// The standard's own examples (PS3.5 annexes H, I, J, K), and one for every other term.
INSTANTIATE_TEST_SUITE_P(Standard, Examples,
  testing::Values(
    Example{ "H.3.1", "\\ISO 2022 IR 87",
      "Yamada^Tarou=\x1b$B;3ED\x1b(B^\x1b$BB@O:\x1b(B=\x1b$B$d$^$@\x1b(B^\x1b$B$?$m$&\x1b(B",
      "Yamada^Tarou=山田^太郎=やまだ^たろう" },
    Example{ "H.3.2", "ISO 2022 IR 13\\ISO 2022 IR 87",
      "\xd4\xcf\xc0\xde^\xc0\xdb\xb3=\x1b$B;3ED\x1b(J^\x1b$BB@O:\x1b(J="
      "\x1b$B$d$^$@\x1b(J^\x1b$B$?$m$&\x1b(J",
      "ﾔﾏﾀﾞ^ﾀﾛｳ=山田^太郎=やまだ^たろう" },
    Example{ "I.2", "\\ISO 2022 IR 149",
      "Hong^Gildong=\x1b$)C\xfb\xf3^\x1b$)C\xd1\xce\xd4\xd7=\x1b$)C\xc8\xab^\x1b$)"
      "C\xb1\xe6\xb5\xbf",
      "Hong^Gildong=洪^吉洞=홍^길동" },
    Example{ "J.1", "ISO_IR 192",
      "Wang^XiaoDong=\xe7\x8e\x8b^\xe5\xb0\x8f\xe4\xb8\x9c=", "Wang^XiaoDong=王^小东=" },
    Example{
      "J.3", "GB18030", "Wang^XiaoDong=\xcd\xf5^\xd0\xa1\xb6\xab=", "Wang^XiaoDong=王^小东=" },
    Example{ "K.2", "\\ISO 2022 IR 58",
      "Zhang^XiaoDong=\x1b$)A\xd5\xc5^\x1b$)A\xd0\xa1\xb6\xab=", "Zhang^XiaoDong=张^小东=" },
    Example{ "GBK", "GBK", "\xd6\xd0", "中" },
    Example{ "JIS_X_0212", "\\ISO 2022 IR 87\\ISO 2022 IR 159", "\x1b$(D0!\x1b(B 1", "丂 1" },
    Example{ "Latin1", "ISO_IR 100", "Herz \xfc", "Herz ü" },
    Example{ "Latin1WithGreek", "ISO 2022 IR 100\\ISO 2022 IR 126", "\xe9t\xe9 \x1b-F\xe1\xe2\xe3",
      "été αβγ" },
    Example{ "Latin2", "ISO_IR 101", "p\xb3uco", "płuco" },
    Example{ "Latin3", "ISO_IR 109", "\xf9", "ù" }, Example{ "Latin4", "ISO_IR 110", "\xbf", "ŋ" },
    Example{ "Cyrillic", "ISO_IR 144", "\xbb\xd5\xd3\xda\xd8\xd5", "Легкие" },
    Example{ "Arabic", "ISO_IR 127", "\xe2\xe4\xc8", "قلب" },
    Example{ "Greek", "ISO_IR 126", "\xea\xe1\xf1\xe4\xe9\xdc", "καρδιά" },
    Example{ "Hebrew", "ISO_IR 138", "\xec\xe1", "לב" },
    Example{ "Latin5", "ISO_IR 148", "\xfd", "ı" }, Example{ "Latin9", "ISO_IR 203", "\xa4", "€" },
    Example{ "Thai", "ISO_IR 166", "\xbb\xcd\xb4", "ปอด" },
    Example{ "Katakana", "ISO_IR 13", "\xca\xb2", "ﾊｲ" }));

// Not as the standard wants it, and understood all the same.
INSTANTIATE_TEST_SUITE_P(Wild, Examples,
  testing::Values(Example{ "TermsSpelledOtherwise", "iso-ir 100 ", "\xfc", "ü" },
    Example{ "EscapesThatNoTermNames", "", "\x1b$B:8GY\x1b(B", "左肺" },
    Example{ "EscapeForgotten", "\\ISO 2022 IR 149", "\xc6\xf3", "폐" },
    Example{ "NoWayBack", "\\ISO 2022 IR 87", "\x1b$B:8GY", "左肺" },
    Example{ "JISOf1978", "\\ISO 2022 IR 87", "\x1b$@:8GY\x1b(B", "左肺" },
    Example{ "KatakanaBelow80", "ISO 2022 IR 13", "\x1b(IJ2\x1b(J1", "ﾊｲ1" }));

TEST(DICOMCharacterSet, BackslashWithinACharacterIsNoSeparator)
{
  // 0x5c as second byte: 怒 of JIS X 0208 is 45 5c.
  EXPECT_EQ(DICOMCharacterSet("\\ISO 2022 IR 87").Decode("\x1b$BE\\\x1b(B").Text, "怒");
  // Between values it ends what an escape sequence began.
  const DICOMCharacterSet korean("ISO_IR 100\\ISO 2022 IR 149");
  EXPECT_EQ(korean.Decode("\x1b$)C\xc6\xf3\\\xfc").Text, "폐\\ü");
}

TEST(DICOMCharacterSet, UndeclaredUTF8IsGuessed)
{
  const DecodedText decoded = DICOMCharacterSet("").Decode("Lunge \xc3\xbc");
  EXPECT_EQ(decoded.Text, "Lunge ü");
  EXPECT_EQ(decoded.Outcome, DecodedText::How::Guessed);
}

TEST(DICOMCharacterSet, BytesThatNothingExplainsAreMarked)
{
  for (const char* terms : { "", "ISO_IR 192", "ISO_IR 6", "GB18030", "\\ISO 2022 IR 87" })
  {
    const DecodedText decoded = DICOMCharacterSet(terms).Decode("a\xff");
    EXPECT_EQ(decoded.Text, "a?") << terms;
    EXPECT_EQ(decoded.Outcome, DecodedText::How::Unknown) << terms;
  }
  EXPECT_EQ(DICOMCharacterSet("").Decode("a\x1b[b").Text, "a?[b"); // no set's escape sequence
  EXPECT_EQ(DICOMCharacterSet("").Decode("a\x1b$B:").Text, "a?");  // half a character
}

TEST(DICOMCharacterSet, AnyBytesGiveUTF8)
{
  std::mt19937 random(1);
  const std::string often = "\x1b$B()-ACIJ^=\\";
  for (const char* terms : { "", "ISO_IR 100", "\\ISO 2022 IR 87\\ISO 2022 IR 149", "ISO_IR 13",
         "GB18030", "ISO_IR 192", "nonsense\\\\ISO 2022 IR 99999999999" })
  {
    const DICOMCharacterSet set(terms);
    for (int i = 0; i < 2000; ++i)
    {
      std::string bytes(random() % 12, '\0');
      for (char& byte : bytes)
      {
        byte = random() % 2 ? often[random() % often.size()] : static_cast<char>(random() & 0xff);
      }
      const DecodedText decoded = set.Decode(bytes, i % 2 == 0);
      ASSERT_TRUE(recon::IsUTF8(decoded.Text)) << terms << ", " << i;
    }
  }
}
