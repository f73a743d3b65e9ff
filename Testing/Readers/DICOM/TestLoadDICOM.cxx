// SPDX-License-Identifier: GPL-3.0-or-later
#include "Readers/DICOM/StructureSetBuilder.h"
#include "Readers/ReaderTesting.h"

#include "DICOM/DICOMItem.h"
#include "DICOM/LoadDICOM.h"
#include "DICOM/ReadReferenceSlices.h"
#include "DICOM/StructureSetFile.h"

#include <algorithm>
#include <cstring>
#include <new>

using namespace readertesting;

namespace
{
std::size_t LargestRequest = 0; ///< of memory by DCMTK for values, which asks this way for them
}

void* operator new[](std::size_t size, const std::nothrow_t&) noexcept
{
  LargestRequest = std::max(LargestRequest, size);
  try
  {
    return ::operator new[](size);
  }
  catch (const std::bad_alloc&)
  {
    return nullptr;
  }
}

namespace
{
using LoadDICOM = Folder;

std::string Load(const std::string& name)
{
  const recon::QuietDCMTK quiet;
  return SentenceOf(
    [&]
    {
      DcmFileFormat file;
      recon::LoadDICOM(name, file);
    });
}

std::string Little(std::uint32_t value)
{
  std::string bytes(4, '\0');
  for (std::size_t i = 0; i < 4; ++i)
  {
    bytes[i] = static_cast<char>((value >> (8 * i)) & 0xff);
  }
  return bytes;
}

/// Sequences within items within sequences, in implicit VR without preamble, of a defined length or of none.
std::string Nested(int levels, bool isDefined)
{
  const std::string sequence("\x06\x30\x20\0", 4);
  const std::string item("\xfe\xff\0\xe0", 4);
  const std::string uid = std::string(UID_RTStructureSetStorage) + '\0';
  std::string bytes("\x08\0\x16\0", 4);
  bytes += Little(static_cast<std::uint32_t>(uid.size())) + uid;
  for (int i = 0; i < levels; ++i)
  {
    const auto left = static_cast<std::uint32_t>(16 * (levels - i));
    bytes += sequence + Little(isDefined ? left - 8 : 0xffffffff) + item +
      Little(isDefined ? left - 16 : 0xffffffff);
  }
  for (int i = 0; i < levels && !isDefined; ++i)
  {
    bytes += std::string("\xfe\xff\x0d\xe0\0\0\0\0\xfe\xff\xdd\xe0\0\0\0\0", 16);
  }
  return bytes;
}
}

TEST_F(LoadDICOM, NestedSequencesEndInASentenceInsteadOfTheStack)
{
  for (const bool isDefined : { true, false })
  {
    EXPECT_EQ(Load(this->Write("few", Nested(20, isDefined))), "");
    for (const int levels : { 1000, 100000 })
    {
      const std::string name = this->Write("many", Nested(levels, isDefined));
      ExpectSentence(Load(name), name, "nested deeper");
      EXPECT_FALSE(recon::StructureSetFile::IsStructureSet(this->Name("absent")));
      ExpectSentence(
        SentenceOf([&] { recon::StructureSetFile file(name); }), name, "nested deeper");
    }
  }
}

TEST_F(LoadDICOM, DeflatedOnesUnpackWithinABound)
{
  StructureSetBuilder builder;
  builder.AddROI(1, "A");
  builder.AddContour("CLOSED_PLANAR", "0\\0\\5\\8\\0\\5\\8\\8\\5", 3);
  builder.Save(this->Name("whole"), EXS_DeflatedLittleEndianExplicit);
  EXPECT_EQ(Load(this->Name("whole")), "");
  // Ten million zeros, and as many bytes of empty items.
  for (const bool areItems : { false, true })
  {
    StructureSetBuilder bomb;
    if (areItems)
    {
      auto* sequence = new DcmSequenceOfItems(DCM_StructureSetROISequence);
      for (int i = 0; i < 1000000; ++i)
      {
        sequence->append(new DcmItem());
      }
      ASSERT_TRUE(bomb.Data().insert(sequence).good());
    }
    else
    {
      const std::vector<Uint8> zeros(10000000, 0);
      ASSERT_TRUE(bomb.Data()
                    .putAndInsertUint8Array(DCM_EncapsulatedDocument, zeros.data(),
                      static_cast<unsigned long>(zeros.size()))
                    .good());
    }
    const std::string name = this->Name("bomb");
    bomb.Save(name, EXS_DeflatedLittleEndianExplicit);
    ASSERT_LT(std::filesystem::file_size(name), 50000u);
    ExpectSentence(Load(name), name, "unpacks to more than 64 times its size");
  }
}

TEST_F(LoadDICOM, NoMemoryIsTakenForAValueThatIsOnlyAnnounced)
{
  // A deflated data set, in a block that is stored as it is, whose value is announced to be 4 GB long and ends at once.
  const std::string element =
    std::string("\x42\0\x11\0OB\0\0", 8) + Little(0xf0000000) + "and no more.";
  const auto size = static_cast<std::uint32_t>(element.size());
  const std::string deflated =
    '\1' + Little(size).substr(0, 2) + Little(~size).substr(0, 2) + element;
  const std::string uid = std::string(UID_DeflatedExplicitVRLittleEndianTransferSyntax);
  const std::string name = this->Write("announced",
    std::string(128, '\0') + "DICM" + std::string("\x02\0\x10\0UI", 6) +
      static_cast<char>(uid.size()) + '\0' + uid + deflated);
  LargestRequest = 0;
  ExpectSentence(Load(name), name, "damaged or truncated");
  EXPECT_GT(LargestRequest, 0u);
  EXPECT_LT(LargestRequest, 1000000u);
}

TEST_F(LoadDICOM, WhatIsWrittenOverTheFileLaterChangesNothing)
{
  // More than the 4 kB up to which DCMTK reads values at once.
  std::string data;
  for (int i = 0; i < 3000; ++i)
  {
    data += (i ? "\\" : "") + std::to_string(i) + "\\1\\2";
  }
  const auto save = [&](const std::string& roi)
  {
    StructureSetBuilder builder;
    builder.AddROI(1, roi);
    builder.AddContour("CLOSED_PLANAR", data, 3000);
    builder.Save(this->Name("a"));
  };
  save("A");
  recon::StructureSetFile file(this->Name("a"));
  save("Another name of another length");
  recon::Monitor monitor;
  const recon::StructureSetContours contours = file.ReadContours(0, monitor);
  EXPECT_TRUE(contours.File.Report.empty()) << contours.File.Report.front();
  EXPECT_EQ(contours.File.Soup.Points.size(), 3000u);
}

TEST_F(LoadDICOM, WhatComesBeforeAnElementIsThere)
{
  StructureSetBuilder builder;
  builder.AddROI(1, "A");
  builder.Save(this->Name("a"));
  const recon::QuietDCMTK quiet;
  DcmFileFormat file;
  EXPECT_EQ(recon::LoadDICOMUntil(this->Name("a"), file, DCM_StructureSetROISequence), "");
  EXPECT_EQ(recon::GetText(*file.getDataset(), DCM_Modality), "RTSTRUCT");
  EXPECT_FALSE(file.getDataset()->tagExists(DCM_StructureSetROISequence));
  EXPECT_EQ(recon::LoadDICOMUntil(this->Name("b"), file, DCM_Modality), "there is no such file.");
  this->Write("empty", "");
  EXPECT_EQ(recon::LoadDICOMUntil(this->Name("empty"), file, DCM_Modality), "the file is empty.");
}
