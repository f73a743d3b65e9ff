// SPDX-License-Identifier: GPL-3.0-or-later
#include "Readers/DICOM/ReferenceBuilder.h"
#include "Readers/ReaderTesting.h"

#include "DICOM/StructureSetFormatter.h"

#include <csignal>
#include <limits>

#include <sys/resource.h>

using namespace readertesting;

namespace
{
class StructureSetFormatterInvalid : public Folder
{
protected:
  StructureSetFormatterInvalid()
  {
    this->ROI.Description.Name = "Heart";
    this->ROI.Contours.push_back(
      { { { 0, 0, 0 }, { 10, 0, 0 }, { 10, 10, 0 }, { 0, 10, 0 } }, "CLOSED_PLANAR", "cell 3" });
    std::filesystem::create_directory(this->Name("out"));
  }

  /// One sentence with part in it, and nothing written.
  void ExpectRefused(const std::string& part, const std::string& named)
  {
    const std::string sentence = SentenceOf(
      [&]
      {
        recon::WriteStructureSet(
          this->FileName.empty() ? this->Name("out/new.dcm") : this->FileName, this->ROIs(),
          this->Options, this->Monitor);
      });
    ExpectSentence(sentence, named, part);
    EXPECT_TRUE(std::filesystem::is_empty(this->Name("out")));
  }
  std::vector<recon::WrittenROI> ROIs() const { return { this->ROI }; }

  recon::WrittenROI ROI;
  recon::StructureSetOptions Options;
  std::string FileName;
  recon::Monitor Monitor;
};
}

TEST_F(StructureSetFormatterInvalid, NothingToWrite)
{
  this->ROI.Contours.clear();
  this->ExpectRefused("no contours to write", "");
}

TEST_F(StructureSetFormatterInvalid, CoordinatesThatAreNoNumbersOrTooLarge)
{
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), 1e8, -1e300 })
  {
    this->ROI.Contours[0].Points[2][1] = bad;
    this->ExpectRefused(
      std::abs(bad) < 1e301 ? "beyond 100 km" : "not a number", "ROI \"Heart\", cell 3");
  }
}

TEST_F(StructureSetFormatterInvalid, NotPlanar)
{
  this->ROI.Contours[0].Points[2][2] = 1;
  this->ExpectRefused("not planar", "ROI \"Heart\", cell 3");
}

TEST_F(StructureSetFormatterInvalid, PlanarButForRoundingIsWritten)
{
  this->ROI.Contours[0].Points[2][2] = 0.02;
  EXPECT_NO_THROW(recon::WriteStructureSet(
    this->Name("out/new.dcm"), this->ROIs(), this->Options, this->Monitor));
}

TEST_F(StructureSetFormatterInvalid, PlacesThatCannotBeWritten)
{
  this->FileName = this->Name("no folder/new.dcm");
  this->ExpectRefused("there is no folder", this->FileName);
  this->FileName = this->Name("out");
  this->ExpectRefused("it is a folder", this->FileName);
  this->FileName = "/dev/null";
  this->ExpectRefused("it is a device", this->FileName);
}

TEST_F(StructureSetFormatterInvalid, FolderWithoutPermission)
{
  namespace fs = std::filesystem;
  this->FileName = this->Name("closed/new.dcm");
  fs::create_directory(this->Name("closed"));
  fs::permissions(this->Name("closed"), fs::perms::owner_read | fs::perms::owner_exec);
  if (std::ofstream(this->Name("closed/probe")).good())
  {
    fs::permissions(this->Name("closed"), fs::perms::owner_all);
    GTEST_SKIP() << "this user may write anywhere (root)";
  }
  this->ExpectRefused("its folder cannot be written to", this->FileName);
  fs::permissions(this->Name("closed"), fs::perms::owner_all);
}

TEST_F(StructureSetFormatterInvalid, FullDisk)
{
  // A limit to the size of files stands for it; once the data exceed stdio's buffer and once not.
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
  for (const rlim_t size : { 100, 2000 })
  {
    std::ofstream(this->Name("old.dcm")) << "what was there";
    rlimit limit = before;
    limit.rlim_cur = size;
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
    this->ExpectRefused("the disk is full", "new.dcm");
    this->FileName = this->Name("old.dcm");
    this->ExpectRefused("the disk is full", "old.dcm");
    this->FileName.clear();
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
    EXPECT_EQ(Bytes(this->Name("old.dcm")), "what was there");
    for (int i = 0; i < 10000; ++i)
    {
      this->ROI.Contours[0].Points.push_back({ 0, 10.0 - i * 1e-3, 0 });
    }
  }
  std::signal(SIGXFSZ, ignored);
}

TEST_F(StructureSetFormatterInvalid, ReferenceIsNotOverwritten)
{
  StructureSetBuilder builder;
  FillReference(builder, { 0, 1 }, 2);
  builder.Save(this->Name("reference.dcm"));
  const std::string before = Bytes(this->Name("reference.dcm"));
  this->Options.Reference = this->Name("reference.dcm");
  this->FileName = this->Name("reference.dcm");
  this->ExpectRefused("the reference itself", this->FileName);
  // By another path, and through a link.
  this->FileName = this->Name("out/../reference.dcm");
  this->ExpectRefused("the reference itself", this->FileName);
  std::filesystem::create_symlink(this->Name("reference.dcm"), this->Name("link.dcm"));
  this->FileName = this->Name("link.dcm");
  this->ExpectRefused("the reference itself", this->FileName);
  EXPECT_EQ(Bytes(this->Name("reference.dcm")), before);
}

TEST_F(StructureSetFormatterInvalid, ReferencesThatAreNone)
{
  this->Options.Reference = this->Name("absent.dcm");
  this->ExpectRefused("there is no such file", "absent.dcm");
  this->Options.Reference = this->Write("empty.dcm", "");
  this->ExpectRefused("the file is empty", "empty.dcm");
  this->Options.Reference = this->Write("text.dcm", "Some text that is no DICOM at all.");
  this->ExpectRefused("", "text.dcm");

  StructureSetBuilder builder;
  FillReference(builder, { 0, 1 }, 2);
  builder.Save(this->Name("whole.dcm"));
  const std::string whole = Bytes(this->Name("whole.dcm"));
  this->Options.Reference = this->Write("half.dcm", whole.substr(0, whole.size() / 2));
  this->ExpectRefused("truncated", "half.dcm");

  StructureSetBuilder plan;
  plan.Put(plan.Data(), DCM_SOPClassUID, UID_RTPlanStorage);
  plan.Save(this->Name("plan.dcm"));
  this->Options.Reference = this->Name("plan.dcm");
  this->ExpectRefused("class RTPlanStorage, expected an RT structure set", "plan.dcm");
}

TEST_F(StructureSetFormatterInvalid, FoldersThatAreNoReference)
{
  std::filesystem::create_directory(this->Name("images"));
  this->Options.Reference = this->Name("images");
  this->ExpectRefused("there are no images", "images");
  SaveImage(this->Name("images/a"), 0, "1.2.3.1");
  SaveImage(this->Name("images/b"), 1, "1.2.3.2");
  this->ExpectRefused("several series", "images");
}

TEST_F(StructureSetFormatterInvalid, DamagedReferencesEndInASentenceOrAWholeFile)
{
  StructureSetBuilder builder;
  FillReference(builder, { 0, 1, 2 }, 4);
  builder.Save(this->Name("whole.dcm"));
  const std::string whole = Bytes(this->Name("whole.dcm"));
  std::mt19937 random(1);
  int refused = 0;
  int written = 0;
  for (int i = 0; i < 400; ++i)
  {
    std::string bytes = whole;
    for (int k = 0; k <= i % 4; ++k)
    {
      // Behind the preamble, where nothing is read.
      bytes[128 + random() % (bytes.size() - 128)] = static_cast<char>(random() & 0xff);
    }
    if (i % 8 == 7)
    {
      bytes.resize(random() % bytes.size());
    }
    this->Options.Reference = this->Folder::Write("reference.dcm", bytes);
    const std::string sentence = SentenceOf(
      [&]
      {
        recon::WriteStructureSet(
          this->Name("out/new.dcm"), this->ROIs(), this->Options, this->Monitor);
      });
    if (sentence.empty())
    {
      ++written;
      EXPECT_TRUE(recon::StructureSetFile::IsStructureSet(this->Name("out/new.dcm"))) << i;
      std::filesystem::remove(this->Name("out/new.dcm"));
    }
    else
    {
      ++refused;
      EXPECT_EQ(sentence.back(), '.') << sentence;
    }
    EXPECT_TRUE(std::filesystem::is_empty(this->Name("out"))) << i;
  }
  EXPECT_GT(refused, 50);
  EXPECT_GT(written, 50);
}

TEST_F(StructureSetFormatterInvalid, AbortLeavesNoFile)
{
  class Stop : public recon::Monitor
  {
  public:
    bool AbortRequested() override { return true; }
  };
  Stop stop;
  EXPECT_THROW(
    recon::WriteStructureSet(this->Name("out/new.dcm"), this->ROIs(), this->Options, stop),
    recon::Aborted);
  EXPECT_TRUE(std::filesystem::is_empty(this->Name("out")));
}
