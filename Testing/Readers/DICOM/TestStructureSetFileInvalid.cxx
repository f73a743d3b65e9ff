// SPDX-License-Identifier: GPL-3.0-or-later
#include "Readers/DICOM/StructureSetBuilder.h"
#include "Readers/ReaderTesting.h"

#include "DICOM/StructureSetFile.h"

using namespace readertesting;

namespace
{
const char* const Triangle = "0\\0\\1\\4\\0\\1\\4\\3.5\\1";

class StructureSetInvalid : public Folder
{
protected:
  /// All that can be had from a file: what a truncated one must not give less of without an error.
  std::string Contents(const std::string& fileName)
  {
    recon::StructureSetFile file(fileName);
    std::string contents;
    for (std::size_t i = 0; i < file.GetROIs().size(); ++i)
    {
      const recon::StructureSetContours contours =
        file.ReadContours(static_cast<int>(i), this->Monitor);
      contents += file.GetROIs()[i].Name + ": ";
      for (const recon::LoopSoup::Chain& chain : contours.File.Soup.Chains)
      {
        contents += std::to_string(chain.Points.size()) + " ";
      }
    }
    return contents;
  }
  std::string Sentence(const std::string& fileName)
  {
    return SentenceOf([&] { this->Contents(fileName); });
  }
  void Expect(StructureSetBuilder& builder, const std::string& part)
  {
    const std::string fileName = this->Name("bad set.dcm");
    builder.Save(fileName);
    ExpectSentence(this->Sentence(fileName), fileName, part);
  }
  void ExpectBytes(const std::string& bytes, const std::string& part)
  {
    const std::string fileName = this->Write("bad bytes.dcm", bytes);
    ExpectSentence(this->Sentence(fileName), fileName, part);
    EXPECT_FALSE(recon::StructureSetFile::IsStructureSet(fileName));
  }
  recon::Monitor Monitor;
};

StructureSetBuilder TwoROIs()
{
  StructureSetBuilder builder;
  builder.AddROI(1, "A");
  builder.AddContour("CLOSED_PLANAR", Triangle, 3);
  builder.AddContour("CLOSED_PLANAR", Triangle, 3);
  builder.AddROI(2, "B");
  builder.AddContour("CLOSED_PLANAR", Triangle, 3);
  return builder;
}
}

TEST_F(StructureSetInvalid, TruncatedAnywhere)
{
  StructureSetBuilder builder = TwoROIs();
  for (const E_TransferSyntax syntax : { EXS_LittleEndianImplicit, EXS_LittleEndianExplicit })
  {
    for (const E_EncodingType encoding : { EET_ExplicitLength, EET_UndefinedLength })
    {
      builder.Save(this->Name("whole.dcm"), syntax, true, encoding);
      const std::string whole = Bytes(this->Name("whole.dcm"));
      const std::string contents = this->Contents(this->Name("whole.dcm"));
      int errors = 0;
      for (std::size_t size = 0; size < whole.size(); ++size)
      {
        const std::string fileName = this->Write("part.dcm", whole.substr(0, size));
        const std::string sentence = this->Sentence(fileName);
        errors += !sentence.empty();
        if (sentence.empty())
        {
          // Only the types of the ROIs, which come last, may be missing.
          EXPECT_EQ(this->Contents(fileName), contents) << "whole at " << size << " bytes?";
        }
        else
        {
          ExpectSentence(sentence, fileName, "Cannot read");
        }
      }
      EXPECT_GT(errors, static_cast<int>(whole.size()) * 9 / 10);
    }
  }
}

TEST_F(StructureSetInvalid, EmptyAbsentTextOrRandom)
{
  this->ExpectBytes("", "the file is empty");
  ExpectSentence(this->Sentence(this->Name("absent.dcm")), "absent.dcm", "no such file");
  this->ExpectBytes("S 1\nv 3 z 0\n{\n0 0\n1 0\n1 1\n}\n", "no DICOM file");
  this->ExpectBytes(std::string(4096, '\0'), "no DICOM file");
  for (unsigned int seed = 0; seed < 20; ++seed)
  {
    this->ExpectBytes(RandomBytes(4096, seed), "no DICOM file");
    this->ExpectBytes(std::string(128, '\0') + "DICM" + RandomBytes(4096, seed), "no DICOM file");
  }
}

TEST_F(StructureSetInvalid, OtherDICOMObjects)
{
  StructureSetBuilder builder = TwoROIs();
  StructureSetBuilder::Put(builder.Data(), DCM_SOPClassUID, UID_CTImageStorage);
  this->Expect(builder, "of class CTImageStorage, expected an RT structure set");
  EXPECT_FALSE(recon::StructureSetFile::IsStructureSet(this->Name("bad set.dcm")));
}

TEST_F(StructureSetInvalid, MissingSequences)
{
  for (const DcmTagKey& tag : { DCM_StructureSetROISequence, DCM_ROIContourSequence })
  {
    StructureSetBuilder builder = TwoROIs();
    ASSERT_TRUE(builder.Data().findAndDeleteElement(tag).good());
    this->Expect(builder, std::string(tag.toString().c_str()) + " is missing");
    ASSERT_TRUE(builder.Data().insertEmptyElement(tag).good());
    this->Expect(builder, std::string(tag.toString().c_str()) + " is missing or empty");
  }
}

TEST_F(StructureSetInvalid, NoNumbersAtAll)
{
  StructureSetBuilder builder = TwoROIs();
  for (const int i : { 0, 1 })
  {
    DcmItem* roi = nullptr;
    ASSERT_TRUE(builder.Data().findAndGetSequenceItem(DCM_StructureSetROISequence, roi, i).good());
    roi->findAndDeleteElement(DCM_ROINumber);
  }
  this->Expect(builder, "none of its ROIs has a ROINumber (3006,0022)");
}

TEST_F(StructureSetInvalid, CutOffBehindTheContours)
{
  StructureSetBuilder builder = TwoROIs();
  ASSERT_TRUE(builder.Data().findAndDeleteElement(DCM_RTROIObservationsSequence).good());
  DcmItem* item = nullptr;
  ASSERT_TRUE(builder.Data().findOrCreateSequenceItem(DCM_ROIContourSequence, item, -2).good());
  this->Expect(builder, "has no ReferencedROINumber (3006,0084)");
}

TEST_F(StructureSetInvalid, HugeLengths)
{
  // Every 32 bit length of the implicit encoding made huge, one after the other.
  StructureSetBuilder builder = TwoROIs();
  builder.Save(this->Name("whole.dcm"), EXS_LittleEndianImplicit, false);
  const std::string whole = Bytes(this->Name("whole.dcm"));
  const std::string contents = this->Contents(this->Name("whole.dcm"));
  int errors = 0;
  for (std::size_t at = 0; at + 4 <= whole.size(); at += 2)
  {
    std::string bytes = whole;
    bytes.replace(at, 4, "\xF0\xFF\xFF\x7F");
    errors += !this->Sentence(this->Write("huge.dcm", bytes)).empty();
  }
  EXPECT_GT(errors, static_cast<int>(whole.size()) / 8);
}

TEST_F(StructureSetInvalid, Mutated)
{
  StructureSetBuilder builder = TwoROIs();
  builder.Save(this->Name("whole.dcm"));
  const std::string whole = Bytes(this->Name("whole.dcm"));
  std::mt19937 random(5);
  for (int i = 0; i < 1000; ++i)
  {
    std::string bytes = whole;
    bytes[128 + random() % (bytes.size() - 128)] = static_cast<char>(random() & 0xff);
    this->Sentence(this->Write("mutated.dcm", bytes)); // a sentence or none, but nothing worse
  }
}
