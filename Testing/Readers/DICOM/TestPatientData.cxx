// SPDX-License-Identifier: GPL-3.0-or-later
// Who the patient is stands in the file that is written, where a reference tells it, and nowhere else: in no sentence that
// is shown or logged, however a file is damaged. And a reference is its own folder, not what lies around it.
#include "Readers/DICOM/ReferenceBuilder.h"
#include "Readers/ReaderTesting.h"

#include "DICOM/ReadReferenceSlices.h"
#include "DICOM/StructureSetFile.h"
#include "DICOM/StructureSetFormatter.h"

using namespace readertesting;

namespace
{
class PatientData : public Folder
{
protected:
  /// Whatever a file is taken for, every sentence that comes of it.
  std::string Said(const std::string& fileName)
  {
    std::string said;
    const auto add = [&said](const std::vector<std::string>& lines)
    {
      for (const std::string& line : lines)
      {
        said += line + "\n";
      }
    };
    add({ SentenceOf(
      [&]
      {
        recon::StructureSetFile file(fileName);
        add(file.GetReport());
        for (std::size_t i = 0; i < file.GetROIs().size(); ++i)
        {
          add(file.ReadContours(static_cast<int>(i), this->Monitor).File.Report);
        }
      }) });
    add(
      { SentenceOf([&] { add(recon::ReadReferenceSlices(fileName, "", this->Monitor).Report); }) });
    add({ SentenceOf(
      [&]
      {
        recon::WrittenROI roi;
        roi.Description.Name = "new";
        roi.Contours.push_back(
          { { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 } }, "CLOSED_PLANAR", "cell 0" });
        recon::StructureSetOptions options;
        options.Reference = fileName;
        add(recon::WriteStructureSet(this->Name("written"), { roi }, options, this->Monitor));
      }) });
    return said;
  }

  recon::Monitor Monitor;
};
}

TEST_F(PatientData, IsInNoSentence)
{
  StructureSetBuilder builder;
  FillReference(builder, { 0, 1 }, 2);
  builder.Save(this->Name("set"));
  std::filesystem::create_directory(this->Name("series"));
  SaveImage(this->Name("series/image"), 1);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  std::string said;
  for (const char* name : { "set", "series/image" })
  {
    const std::string whole = Bytes(this->Name(name));
    ASSERT_NE(whole.find("4711"), std::string::npos);
    for (std::size_t at = 132; at < whole.size(); at += 7)
    {
      std::string changed = whole;
      changed[at] = static_cast<char>(changed[at] ^ (1 << (at % 8)));
      said += this->Said(this->Write(name, changed));
      said += this->Said(this->Write(name, whole.substr(0, at)));
    }
  }
  const std::string printed =
    testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
  EXPECT_EQ(printed, "");
  const std::string folder = this->Name(""); // whose name has random digits
  for (std::size_t at = said.find(folder); at != std::string::npos; at = said.find(folder, at))
  {
    said.erase(at, folder.size());
  }
  EXPECT_GT(said.size(), 10000u) << "damaged files say what is wrong";
  for (const char* secret : { "ller", "Eva", "4711", "20260102" })
  {
    EXPECT_EQ(said.find(secret), std::string::npos)
      << said.substr(std::min(said.find(secret), said.size()), 60);
  }
}

TEST_F(PatientData, OfAReferenceIsReadInItsOwnFolderOnly)
{
  namespace fs = std::filesystem;
  fs::create_directories(this->Name("above/series/below"));
  for (int slice = 0; slice < 3; ++slice)
  {
    SaveImage(this->Name("above/series/" + std::to_string(slice)), slice);
    SaveImage(this->Name("above/" + std::to_string(slice)), 10 + slice);
    SaveImage(this->Name("above/series/below/" + std::to_string(slice)), 20 + slice);
  }
  for (const char* reference : { "above/series", "above/series/", "above/series/1" })
  {
    const auto slices = recon::ReadReferenceSlices(this->Name(reference), "", this->Monitor).Slices;
    ASSERT_EQ(slices.size(), 3u) << reference;
    EXPECT_NEAR(slices.back().Offset, 2 * SliceSpacing, 1e-9) << reference;
  }
  // By a name without a folder as well.
  const fs::path before = fs::current_path();
  fs::current_path(this->Name("above/series"));
  EXPECT_EQ(recon::ReadReferenceSlices("1", "", this->Monitor).Slices.size(), 3u);
  fs::current_path(before);
}
