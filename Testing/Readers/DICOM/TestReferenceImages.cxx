// SPDX-License-Identifier: GPL-3.0-or-later
#include "Readers/DICOM/ReferenceBuilder.h"
#include "Readers/ReaderTesting.h"

#include "DICOM/ReferenceImages.h"

using namespace readertesting;

namespace
{
class ReferenceImages : public Folder
{
protected:
  ReferenceImages()
  {
    std::filesystem::create_directory(this->Name("images"));
    for (int slice = 0; slice < 5; ++slice)
    {
      this->Save("CT" + std::to_string(slice), slice);
    }
    this->Folder::Write("images/notes.txt", "no image");
  }
  void Save(const std::string& name, int slice, const ImageKind& kind = {})
  {
    SaveImage(this->Name("images/" + name), slice, kind);
  }
  recon::ReferenceImages Read(const std::string& series = "1.2.3.8")
  {
    const recon::QuietDCMTK quiet;
    return recon::ReadReferenceImages(this->Name("images"), series, this->Monitor);
  }
  /// The slices are those of five images, and the report is one line with these parts.
  void ExpectOneLine(const recon::ReferenceImages& images, const std::vector<std::string>& parts)
  {
    ASSERT_EQ(images.Slices.size(), 5u);
    for (int slice = 0; slice < 5; ++slice)
    {
      EXPECT_EQ(images.Slices[slice].InstanceUID, ImageUID(slice));
    }
    ASSERT_EQ(images.Report.size(), 1u);
    for (const std::string& part : parts)
    {
      EXPECT_NE(images.Report[0].find(part), std::string::npos) << part << ": " << images.Report[0];
    }
  }
  recon::Monitor Monitor;
};
}

TEST_F(ReferenceImages, AreThoseOfTheSeries)
{
  ImageKind other;
  other.Series = "1.2.3.77";
  this->Save("other", 7, other);
  const recon::ReferenceImages images = this->Read();
  EXPECT_EQ(images.Slices.size(), 5u);
  EXPECT_EQ(images.FileNames.size(), 5u);
  EXPECT_TRUE(images.Report.empty());
  const std::string sentence = SentenceOf([&] { this->Read(""); });
  ExpectSentence(sentence, this->Name("images"), "several series");
}

TEST_F(ReferenceImages, LocalizersAreLeftOut)
{
  ImageKind across;
  across.Orientation = "1\\0\\0\\0\\0\\-1";
  this->Save("scout", 90, across);
  across.Orientation = "0\\1\\0\\0\\0\\-1";
  this->Save("scout2", 91, across);
  const recon::ReferenceImages images = this->Read();
  this->ExpectOneLine(images, { "lie across", "scout and scout2" });
  EXPECT_EQ(images.FileNames.size(), 7u); // which are not to be overwritten all the same
}

TEST_F(ReferenceImages, LocalizersThatSaySoAreLeftOutHoweverMany)
{
  ImageKind across;
  across.Orientation = "1\\0\\0\\0\\0\\-1";
  across.Type = "ORIGINAL\\PRIMARY\\LOCALIZER";
  for (int i = 0; i < 7; ++i)
  {
    this->Save("scout" + std::to_string(i), 90 + i, across);
  }
  this->ExpectOneLine(this->Read(), { "Localizers", "scout0, scout1, scout2 and 4 more" });
}

TEST_F(ReferenceImages, CutOffAnywhereAnImageIsASliceOrNamed)
{
  const std::string whole = Bytes(this->Name("images/CT4"));
  int named = 0;
  for (std::size_t size = 0; size <= whole.size(); ++size)
  {
    this->Folder::Write("images/CT4.dcm", whole.substr(0, size));
    std::filesystem::remove(this->Name("images/CT4"));
    const recon::ReferenceImages images = this->Read();
    EXPECT_EQ(images.Slices.size() + images.Report.size(), 5u) << size << " bytes";
    named += static_cast<int>(images.Report.size());
  }
  EXPECT_GT(named, 0);
  EXPECT_LT(named, static_cast<int>(whole.size()));
}

TEST_F(ReferenceImages, DirectionsThatDifferByRoundingAreOne)
{
  ImageKind rounded;
  rounded.Orientation = "1\\0\\0.0005\\0\\1\\-0.0005";
  this->Save("CT5", 5, rounded);
  const recon::ReferenceImages images = this->Read();
  EXPECT_EQ(images.Slices.size(), 6u);
  EXPECT_TRUE(images.Report.empty());
}

TEST_F(ReferenceImages, ImagesAboutAnAxisAreAllMeant)
{
  std::filesystem::remove_all(this->Name("images"));
  std::filesystem::create_directory(this->Name("images"));
  for (const char* column : { "0\\0\\1", "0\\0.5\\0.866", "0\\0.866\\0.5", "0\\1\\0" })
  {
    ImageKind kind;
    kind.Orientation = std::string("1\\0\\0\\") + column;
    this->Save(std::string(column).substr(0, 5), 0, kind);
  }
  const recon::ReferenceImages images = this->Read();
  EXPECT_EQ(images.Slices.size(), 4u);
  EXPECT_TRUE(images.Report.empty());
}

TEST_F(ReferenceImages, DamagedFilesAreNamed)
{
  const std::string whole = Bytes(this->Name("images/CT1"));
  this->Folder::Write("images/half", whole.substr(0, whole.size() / 2));
  this->Folder::Write("images/short.dcm", whole.substr(0, 60));
  this->Folder::Write("images/empty.DCM", "");
  this->ExpectOneLine(this->Read(), { "damaged or truncated", "empty.DCM, half and short.dcm" });
}

TEST_F(ReferenceImages, ImagesWithoutPlaneAreNamed)
{
  ImageKind kind;
  kind.Orientation = "";
  this->Save("flat", 9, kind);
  kind.Orientation = "1\\0\\0\\1\\0\\0"; // no plane either
  this->Save("line", 10, kind);
  this->ExpectOneLine(this->Read(), { "without position or orientation", "flat and line" });
}

TEST_F(ReferenceImages, ImagesOfAnotherFrameAreLeftOut)
{
  ImageKind kind;
  kind.Frame = "1.2.3.10";
  this->Save("elsewhere", 9, kind);
  this->ExpectOneLine(this->Read(), { "another frame of reference", "elsewhere" });
}

TEST_F(ReferenceImages, WithoutPreamble)
{
  ImageKind kind;
  kind.Preamble = false;
  for (int slice = 0; slice < 5; ++slice)
  {
    this->Save("CT" + std::to_string(slice), slice, kind);
  }
  const recon::ReferenceImages images = this->Read();
  EXPECT_EQ(images.Slices.size(), 5u);
  EXPECT_TRUE(images.Report.empty());
}

TEST_F(ReferenceImages, NoneIsAnError)
{
  ExpectSentence(SentenceOf([&] { this->Read("1.2.3.99"); }), "images", "no image of the series");
  std::filesystem::remove_all(this->Name("images"));
  std::filesystem::create_directory(this->Name("images"));
  this->Folder::Write("images/cut.dcm", "DICM");
  ExpectSentence(SentenceOf([&] { this->Read(""); }), "images", "damaged ones: cut.dcm");
}
