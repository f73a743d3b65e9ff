// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/DICOMText.h"

#include <gtest/gtest.h>

TEST(DICOMText, KeepsWhatIsAllowed)
{
  EXPECT_EQ(recon::DICOMText(" Lt Lung ", 64), "Lt Lung");
  EXPECT_EQ(recon::DICOMText("a\\b\nc", 64), "a_b_c");
  EXPECT_EQ(recon::DICOMText("M\xc3\xbcller", 3), "M\xc3\xbcl"); // characters, not bytes
  EXPECT_EQ(recon::DICOMText("M\xfcller", 64), "M_ller");
  EXPECT_EQ(recon::DICOMText("\xe2\x82", 64), "__"); // cut off
  EXPECT_EQ(recon::DICOMText(std::string(70, 'x'), 64), std::string(64, 'x'));
  EXPECT_EQ(recon::CodeString("ptv-1"), "PTV_1");
  EXPECT_EQ(recon::CodeString("a very long type of ROI"), "A VERY LONG TYPE");
}

TEST(DICOMText, TellsUTF8)
{
  for (const char* text : { "", "a", "\xc3\xbc", "\xe2\x82\xac", "\xf0\x9f\xab\x80", "左肺" })
  {
    EXPECT_TRUE(recon::IsUTF8(text)) << text;
  }
  // Alone, cut off, overlong, a surrogate, beyond Unicode.
  for (const char* text :
    { "\xfc", "\x80", "\xe2\x82", "\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80" })
  {
    EXPECT_FALSE(recon::IsUTF8(text));
  }
  EXPECT_TRUE(recon::IsASCII("a~"));
  EXPECT_FALSE(recon::IsASCII("\xc3\xbc"));
}
