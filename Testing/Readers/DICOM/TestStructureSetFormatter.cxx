// SPDX-License-Identifier: GPL-3.0-or-later
#include "Readers/DICOM/ReferenceBuilder.h"
#include "Readers/ReaderTesting.h"

#include "DICOM/DICOMItem.h"
#include "DICOM/LoadDICOM.h"
#include "DICOM/StructureSetFormatter.h"

#include <cmath>
#include <numeric>
#include <set>

using namespace readertesting;

namespace
{
recon::WrittenROI Square(const std::string& name, double z)
{
  recon::WrittenROI roi;
  roi.Description.Name = name;
  roi.Contours.push_back(
    { { { 0, 0, z }, { 4, 0, z }, { 4, 3.5, z }, { 0, 3.5, z } }, "CLOSED_PLANAR", "cell 0" });
  return roi;
}

class StructureSetFormatter : public Folder
{
protected:
  std::vector<std::string> Write(
    const std::vector<recon::WrittenROI>& rois, const std::string& name = "new.dcm")
  {
    return recon::WriteStructureSet(this->Name(name), rois, this->Options, this->Monitor);
  }
  std::string Reference(const std::vector<int>& slices, int listed)
  {
    StructureSetBuilder builder;
    FillReference(builder, slices, listed);
    builder.Save(this->Name("reference.dcm"));
    return this->Name("reference.dcm");
  }
  DcmItem& Load(const std::string& name = "new.dcm")
  {
    recon::LoadDICOM(this->Name(name), this->File);
    return *this->File.getDataset();
  }
  std::size_t NumberOfFiles() const
  {
    const std::filesystem::path folder = std::filesystem::path(this->Name("x")).parent_path();
    return static_cast<std::size_t>(std::distance(
      std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
  }
  /// The image that each contour of the last ROI refers to; empty for none.
  std::vector<std::string> ImagesOfLast(DcmItem& data)
  {
    std::vector<std::string> images;
    for (DcmItem* contour :
      recon::ItemsOf(*recon::ItemsOf(data, DCM_ROIContourSequence).back(), DCM_ContourSequence))
    {
      const auto items = recon::ItemsOf(*contour, DCM_ContourImageSequence);
      images.push_back(
        items.empty() ? "" : recon::GetText(*items[0], DCM_ReferencedSOPInstanceUID));
    }
    return images;
  }
  recon::WrittenROI Stack(const std::vector<double>& heights)
  {
    recon::WrittenROI roi;
    roi.Description.Name = "Stack";
    for (const double z : heights)
    {
      roi.Contours.push_back(Square("", z).Contours[0]);
    }
    return roi;
  }

  recon::StructureSetOptions Options;
  recon::Monitor Monitor;
  DcmFileFormat File;
};

std::vector<int> Range(int count)
{
  std::vector<int> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}
}

TEST_F(StructureSetFormatter, IsReadBackAsItWas)
{
  recon::WrittenROI roi = Square("Lung", 1.25);
  roi.Description.Number = 7;
  roi.Description.Type = "ORGAN";
  roi.Description.HasColor = true;
  roi.Description.Color = { 255, 128, 0 };
  const double third = 1.0 / 3;
  // A tilted plane, a point, an open line in a plane and one in none.
  roi.Contours.push_back(
    { { { 0, 0, 0 }, { third, 0, third }, { third, 1, 1 + third }, { 0, 1, 1 } }, "CLOSED_PLANAR",
      "" });
  roi.Contours.push_back({ { { 1, 2, 3 } }, "POINT", "" });
  roi.Contours.push_back({ { { 0, 0, 0 }, { 1, 2, 3 } }, "OPEN_PLANAR", "" });
  roi.Contours.push_back(
    { { { 0, 0, 0 }, { 5, 0, 0 }, { 5, 5, 0 }, { 5, 5, 5 } }, "OPEN_NONPLANAR", "" });
  const std::vector<std::string> report = this->Write({ roi });
  ASSERT_EQ(report.size(), 1u);
  EXPECT_EQ(report[0].rfind("No reference is set", 0), 0u) << report[0];
  EXPECT_EQ(this->NumberOfFiles(), 1u);

  recon::StructureSetFile file(this->Name("new.dcm"));
  ASSERT_EQ(file.GetROIs().size(), 1u);
  const recon::StructureSetROI& read = file.GetROIs()[0];
  EXPECT_EQ(read.Number, 7);
  EXPECT_EQ(read.Name, "Lung");
  EXPECT_EQ(read.Type, "ORGAN");
  EXPECT_EQ(read.Color, roi.Description.Color);
  const recon::StructureSetContours contours = file.ReadContours(0, this->Monitor);
  EXPECT_TRUE(contours.File.Report.empty());
  ASSERT_EQ(contours.File.Soup.Chains.size(), roi.Contours.size());
  for (std::size_t c = 0; c < roi.Contours.size(); ++c)
  {
    const std::vector<int>& points = contours.File.Soup.Chains[c].Points;
    EXPECT_EQ(contours.GeometricTypes[c], roi.Contours[c].GeometricType);
    ASSERT_EQ(points.size(), roi.Contours[c].Points.size());
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      for (int a = 0; a < 3; ++a)
      {
        EXPECT_NEAR(contours.File.Soup.Points[points[p]][a], roi.Contours[c].Points[p][a], 5.1e-7);
      }
    }
  }
}

TEST_F(StructureSetFormatter, ContoursOfAnyLengthFit)
{
  // 1.6 MB of text, where an explicit VR has room for 64 kB.
  recon::WrittenROI roi;
  roi.Description.Name = "Large";
  roi.Contours.push_back({ {}, "CLOSED_PLANAR", "" });
  constexpr int count = 50000;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 6.283185307179586 * i / count;
    roi.Contours[0].Points.push_back({ 100 * std::cos(angle), 100 * std::sin(angle), -12.5 });
  }
  this->Write({ roi });
  recon::StructureSetFile file(this->Name("new.dcm"));
  EXPECT_EQ(file.ReadContours(0, this->Monitor).File.Soup.Points.size(), std::size_t(count));
  this->Load();
  EXPECT_EQ(this->File.getDataset()->getOriginalXfer(), EXS_LittleEndianImplicit);
}

TEST_F(StructureSetFormatter, TakesPatientStudyAndImagesOfTheReference)
{
  this->Options.Reference = this->Reference(Range(10), 10);
  this->Options.Label = "A label that is much too long";
  this->Options.GenerationAlgorithm = "SEMIAUTOMATIC";
  EXPECT_TRUE(this->Write({ Square("Heart", 6) }).empty());
  DcmItem& data = this->Load();
  const auto text = [&data](const DcmTagKey& key) { return recon::GetText(data, key); };
  EXPECT_EQ(text(DCM_PatientName), "M\xfcller^Eva"); // its character set as it is
  EXPECT_EQ(text(DCM_SpecificCharacterSet), "ISO_IR 100");
  EXPECT_EQ(text(DCM_PatientID), "4711");
  EXPECT_EQ(text(DCM_StudyInstanceUID), "1.2.3.4");
  EXPECT_EQ(text(DCM_StudyDate), "20260102");
  EXPECT_EQ(text(DCM_FrameOfReferenceUID), "1.2.3.9");
  EXPECT_EQ(text(DCM_StructureSetLabel), "A label that is");
  EXPECT_EQ(text(DCM_ApprovalStatus), "UNAPPROVED");
  EXPECT_EQ(text(DCM_StructureSetDescription), recon::NoMedicalDevice);
  EXPECT_EQ(text(DCM_StructureSetDate).size(), 8u);
  EXPECT_NE(text(DCM_SOPInstanceUID), "1.2.3.4.5");
  EXPECT_EQ(text(DCM_SOPInstanceUID).rfind("2.25.", 0), 0u);
  EXPECT_NE(text(DCM_SOPInstanceUID), text(DCM_SeriesInstanceUID));
  DcmItem& predecessor = *recon::ItemsOf(data, DCM_PredecessorStructureSetSequence).at(0);
  EXPECT_EQ(recon::GetText(predecessor, DCM_ReferencedSOPInstanceUID), "1.2.3.4.5");
  EXPECT_EQ(recon::ItemsOf(data, DCM_ReferencedFrameOfReferenceSequence).size(), 1u);
  DcmItem& roi = *recon::ItemsOf(data, DCM_StructureSetROISequence).back();
  EXPECT_EQ(recon::GetText(roi, DCM_ReferencedFrameOfReferenceUID), "1.2.3.9");
  EXPECT_EQ(recon::GetText(roi, DCM_ROIGenerationAlgorithm), "SEMIAUTOMATIC");
  EXPECT_EQ(this->ImagesOfLast(data), std::vector<std::string>{ ImageUID(2) });
}

TEST_F(StructureSetFormatter, EveryFileHasIdentifiersOfItsOwn)
{
  std::set<std::string> uids;
  for (int i = 0; i < 5; ++i)
  {
    this->Write({ Square("A", 0) });
    DcmItem& data = this->Load();
    for (const DcmTagKey& key :
      { DCM_SOPInstanceUID, DCM_SeriesInstanceUID, DCM_StudyInstanceUID, DCM_FrameOfReferenceUID })
    {
      const std::string uid = recon::GetText(data, key);
      EXPECT_LE(uid.size(), 64u);
      EXPECT_TRUE(uids.insert(uid).second) << uid;
    }
  }
}

TEST_F(StructureSetFormatter, ReferredSliceIsTheNearestWithinHalfASlice)
{
  this->Options.Reference = this->Reference(Range(10), 10);
  const std::vector<std::string> report =
    this->Write({ this->Stack({ 0, 1.4, 1.6, 27, 28.4, 28.6, -1.4, -1.6 }) });
  EXPECT_EQ(this->ImagesOfLast(this->Load()),
    (std::vector<std::string>{
      ImageUID(0), ImageUID(0), ImageUID(1), ImageUID(9), ImageUID(9), "", ImageUID(0), "" }));
  ASSERT_EQ(report.size(), 1u);
  EXPECT_EQ(report[0].rfind("2 of 8 contours lie on none of the 10 images", 0), 0u) << report[0];
}

TEST_F(StructureSetFormatter, SlicesThatNothingIsDrawnOnAreNotMistakenForTheirNeighbours)
{
  // Every third image is drawn on: the planes known are 9 mm apart, the images 3 mm.
  this->Options.Reference = this->Reference({ 0, 3, 6, 9 }, 10);
  this->Write({ this->Stack({ 0, 0.05, 3, 9, 12 }) });
  EXPECT_EQ(this->ImagesOfLast(this->Load()),
    (std::vector<std::string>{ ImageUID(0), ImageUID(0), "", ImageUID(3), "" }));
  // All but the ends: there is no room for further images in between.
  this->Options.Reference = this->Reference({ 2, 3, 4, 5, 6, 7 }, 10);
  this->Write({ this->Stack({ 6, 7, 11 }) });
  EXPECT_EQ(this->ImagesOfLast(this->Load()),
    (std::vector<std::string>{ ImageUID(2), ImageUID(2), ImageUID(4) }));
}

TEST_F(StructureSetFormatter, TiltedContoursReferToNoSlice)
{
  this->Options.Reference = this->Reference(Range(10), 10);
  recon::WrittenROI roi = Square("Tilted", 6);
  roi.Contours[0].Points[2][2] = roi.Contours[0].Points[3][2] = 9;
  EXPECT_EQ(this->Write({ roi }).size(), 1u);
  EXPECT_EQ(this->ImagesOfLast(this->Load()), std::vector<std::string>{ "" });
}

TEST_F(StructureSetFormatter, ROIsOfTheReferenceComeAlongAndAreNeverReplaced)
{
  this->Options.Reference = this->Reference(Range(10), 10);
  recon::WrittenROI body = Square("body", 6);
  body.Description.Number = 1;
  recon::WrittenROI heart = Square("Heart", 6);
  heart.Description.Number = 12;
  const std::vector<std::string> report = this->Write({ body, heart, Square("Heart", 9) });
  ASSERT_EQ(report.size(), 1u);
  EXPECT_NE(report[0].find("\"body\" is written as \"body (2)\" (number 2), \"Heart\" is written "
                           "as \"Heart (2)\" (number 13)."),
    std::string::npos)
    << report[0];
  {
    recon::StructureSetFile file(this->Name("new.dcm"));
    ASSERT_EQ(file.GetROIs().size(), 4u);
    EXPECT_EQ(file.GetROIs()[0].Name, "Body");
    EXPECT_EQ(file.GetROIs()[0].NumberOfContours, 10);
    EXPECT_EQ(file.GetROIs()[1].Name, "body (2)");
    EXPECT_EQ(file.GetROIs()[2].Number, 12);
    EXPECT_TRUE(file.GetReport().empty());
  }
  this->Options.CopyReferenceROIs = false;
  EXPECT_TRUE(this->Write({ body, heart }).empty());
  recon::StructureSetFile file(this->Name("new.dcm"));
  ASSERT_EQ(file.GetROIs().size(), 2u);
  EXPECT_EQ(file.GetROIs()[0].Name, "body");
  EXPECT_EQ(file.GetROIs()[0].Number, 1);
}

TEST_F(StructureSetFormatter, OtherLettersAreWrittenInUTF8)
{
  this->Options.Reference = this->Reference(Range(3), 3);
  this->Write({ Square("L\xc3\xbcnge", 3) });
  DcmItem& data = this->Load();
  EXPECT_EQ(recon::GetText(data, DCM_SpecificCharacterSet), "ISO_IR 192");
  EXPECT_EQ(recon::GetText(data, DCM_PatientName), "M\xc3\xbcller^Eva");
  EXPECT_EQ(recon::StructureSetFile(this->Name("new.dcm")).GetROIs()[1].Name, "L\xc3\xbcnge");
}

TEST_F(StructureSetFormatter, ReferenceInSetsWithEscapeSequences)
{
  // DCMTK cannot convert these with the C library's tables.
  StructureSetBuilder builder;
  FillReference(builder, Range(3), 3);
  StructureSetBuilder::Put(builder.Data(), DCM_SpecificCharacterSet, "\\ISO 2022 IR 87");
  StructureSetBuilder::Put(
    builder.Data(), DCM_PatientName, "Yamada^Tarou=\x1b$B;3ED\x1b(B^\x1b$BB@O:\x1b(B");
  builder.AddROI(2, "\x1b$B:8GY\x1b(B");
  builder.Save(this->Name("reference.dcm"));
  this->Options.Reference = this->Name("reference.dcm");
  for (const std::string& name : { "左肺", "Lung" })
  {
    const std::vector<std::string> report = this->Write({ Square(name, 3) });
    const recon::StructureSetFile file(this->Name("new.dcm"));
    EXPECT_EQ(file.GetROIs()[1].Name, "左肺");
    if (name == "Lung")
    {
      EXPECT_EQ(file.GetROIs()[2].Name, "Lung");
      EXPECT_TRUE(report.empty());
      continue;
    }
    EXPECT_EQ(recon::GetText(this->Load(), DCM_PatientName), "Yamada^Tarou=山田^太郎");
    EXPECT_EQ(file.GetROIs()[2].Name, "左肺 (2)"); // the name is taken
    EXPECT_EQ(report.size(), 1u);
  }
}

TEST_F(StructureSetFormatter, ReferenceWithUnexplainedLetters)
{
  StructureSetBuilder builder;
  FillReference(builder, Range(3), 3);
  StructureSetBuilder::Put(builder.Data(), DCM_SpecificCharacterSet, "ISO_IR 192");
  builder.Save(this->Name("reference.dcm")); // with a patient's name in Latin-1
  this->Options.Reference = this->Name("reference.dcm");
  const std::vector<std::string> report = this->Write({ Square("Größe", 3) });
  ASSERT_EQ(report.size(), 1u);
  EXPECT_NE(report[0].find("PatientName (0010,0010)"), std::string::npos) << report[0];
  EXPECT_EQ(recon::GetText(this->Load(), DCM_PatientName), "M?ller^Eva");
}

TEST_F(StructureSetFormatter, MalformedContoursOfTheReferenceTellNoPlane)
{
  StructureSetBuilder builder;
  FillReference(builder, Range(3), 3);
  DcmItem* contour = nullptr;
  DcmItem* roi = nullptr;
  ASSERT_TRUE(builder.Data().findAndGetSequenceItem(DCM_ROIContourSequence, roi, 0).good());
  ASSERT_TRUE(roi->findAndGetSequenceItem(DCM_ContourSequence, contour, 1).good());
  builder.Put(*contour, DCM_ContourData, "1\\2\\nan");
  builder.Save(this->Name("reference.dcm"));
  this->Options.Reference = this->Name("reference.dcm");
  const std::vector<std::string> report = this->Write({ this->Stack({ 0, 6 }) });
  ASSERT_EQ(report.size(), 1u);
  EXPECT_EQ(report[0].rfind("1 contour of the reference malformed", 0), 0u) << report[0];
  EXPECT_EQ(
    this->ImagesOfLast(this->Load()), (std::vector<std::string>{ ImageUID(0), ImageUID(2) }));
}

TEST_F(StructureSetFormatter, ExclusiveOrIsForAWholeROI)
{
  recon::WrittenROI roi = this->Stack({ 0, 3 });
  roi.Contours[1].GeometricType = "CLOSEDPLANAR_XOR";
  this->Write({ roi, Square("Other", 0) });
  recon::StructureSetFile file(this->Name("new.dcm"));
  EXPECT_EQ(file.ReadContours(0, this->Monitor).GeometricTypes,
    (std::vector<std::string>{ "CLOSEDPLANAR_XOR", "CLOSEDPLANAR_XOR" }));
  EXPECT_EQ(file.ReadContours(1, this->Monitor).GeometricTypes,
    (std::vector<std::string>{ "CLOSED_PLANAR" }));
  this->Options.ExclusiveOr = true;
  this->Write({ Square("Other", 0) });
  EXPECT_EQ(
    recon::StructureSetFile(this->Name("new.dcm")).ReadContours(0, this->Monitor).GeometricTypes,
    (std::vector<std::string>{ "CLOSEDPLANAR_XOR" }));
}

TEST_F(StructureSetFormatter, ImagesMayBeTheReference)
{
  std::filesystem::create_directory(this->Name("images"));
  for (int slice = 0; slice < 5; ++slice)
  {
    SaveImage(this->Name("images/" + std::to_string(slice)), slice);
  }
  this->Folder::Write("images/notes.txt", "no image");
  for (const std::string& reference : { this->Name("images"), this->Name("images/3") })
  {
    this->Options.Reference = reference;
    EXPECT_EQ(this->Write({ this->Stack({ 0, 7.4, 13.6 }) }).size(), 1u);
    DcmItem& data = this->Load();
    EXPECT_EQ(this->ImagesOfLast(data), (std::vector<std::string>{ ImageUID(0), ImageUID(2), "" }));
    EXPECT_EQ(recon::GetText(data, DCM_PatientID), "4711");
    EXPECT_EQ(recon::GetText(data, DCM_FrameOfReferenceUID), "1.2.3.9");
    DcmItem& frame = *recon::ItemsOf(data, DCM_ReferencedFrameOfReferenceSequence).at(0);
    DcmItem& study = *recon::ItemsOf(frame, DCM_RTReferencedStudySequence).at(0);
    DcmItem& series = *recon::ItemsOf(study, DCM_RTReferencedSeriesSequence).at(0);
    EXPECT_EQ(recon::ItemsOf(series, DCM_ContourImageSequence).size(), 5u);
    EXPECT_TRUE(recon::ItemsOf(data, DCM_PredecessorStructureSetSequence).empty());
  }
  // Another series in the folder does not matter where an image says which is meant.
  SaveImage(this->Name("images/other"), 7, "1.2.3.77");
  this->Write({ this->Stack({ 21 }) });
  EXPECT_EQ(this->ImagesOfLast(this->Load()), std::vector<std::string>{ "" });
}

TEST_F(StructureSetFormatter, OnlyImagesOfOneFrameOfReferenceAreReferredTo)
{
  StructureSetBuilder builder;
  FillReference(builder, Range(10), 10);
  // The upper five images go to a frame of reference of their own.
  DcmItem* first = nullptr;
  DcmItem* second = nullptr;
  DcmItem& data = builder.Data();
  ASSERT_TRUE(data.findAndGetSequenceItem(DCM_ReferencedFrameOfReferenceSequence, first, 0).good());
  ASSERT_TRUE(
    data.findOrCreateSequenceItem(DCM_ReferencedFrameOfReferenceSequence, second, -2).good());
  recon::CopyElement(*first, DCM_RTReferencedStudySequence, *second);
  recon::Put(*second, DCM_FrameOfReferenceUID, "1.2.3.10");
  const auto keep = [](DcmItem& frame, int from, int to)
  {
    DcmItem& study = *recon::ItemsOf(frame, DCM_RTReferencedStudySequence).at(0);
    DcmItem& series = *recon::ItemsOf(study, DCM_RTReferencedSeriesSequence).at(0);
    for (int i = 9; i >= 0; --i)
    {
      if (i < from || i >= to)
      {
        series.findAndDeleteSequenceItem(DCM_ContourImageSequence, i);
      }
    }
  };
  keep(*first, 0, 5);
  keep(*second, 5, 10);
  builder.Save(this->Name("reference.dcm"));
  this->Options.Reference = this->Name("reference.dcm");
  const std::vector<std::string> report = this->Write({ this->Stack({ 6, 21 }) });
  EXPECT_EQ(this->ImagesOfLast(this->Load()), (std::vector<std::string>{ ImageUID(2), "" }));
  ASSERT_EQ(report.size(), 2u);
  EXPECT_NE(report[0].find("2 frames of reference"), std::string::npos) << report[0];
  EXPECT_EQ(recon::ItemsOf(this->Load(), DCM_ReferencedFrameOfReferenceSequence).size(), 2u);
}

TEST_F(StructureSetFormatter, ROIsKeepTheFrameThatTheyWereDrawnIn)
{
  // Without a reference.
  recon::WrittenROI ct = Square("CT", 0);
  ct.Description.FrameOfReferenceUID = "1.2.3.9";
  recon::WrittenROI mr = Square("MR", 0);
  mr.Description.FrameOfReferenceUID = "1.2.3.10";
  const auto frames = [this]
  {
    const recon::StructureSetFile file(this->Name("new.dcm"));
    std::vector<std::string> uids;
    for (const recon::StructureSetROI& roi : file.GetROIs())
    {
      uids.push_back(roi.FrameOfReferenceUID);
    }
    return uids;
  };
  EXPECT_EQ(this->Write({ ct, mr }).size(), 1u);
  EXPECT_EQ(frames(), (std::vector<std::string>{ "1.2.3.9", "1.2.3.10" }));
  EXPECT_EQ(recon::ItemsOf(this->Load(), DCM_ReferencedFrameOfReferenceSequence).size(), 2u);

  // With one that has one of the two: the other is left out, and that is all of them an error.
  this->Options.Reference = this->Reference(Range(10), 10);
  this->Options.CopyReferenceROIs = false;
  const std::vector<std::string> report = this->Write({ ct, mr });
  ASSERT_EQ(report.size(), 1u);
  EXPECT_EQ(report[0].rfind("ROI \"MR\" cannot be written", 0), 0u) << report[0];
  EXPECT_EQ(frames(), std::vector<std::string>{ "1.2.3.9" });
  ExpectSentence(SentenceOf([&] { this->Write({ mr }); }), "reference.dcm",
    "drawn in 1.2.3.10, whose coordinates have nothing to do with it");
}

TEST_F(StructureSetFormatter, ReplacesAFileThatIsThere)
{
  this->Folder::Write("new.dcm", "something else");
  this->Write({ Square("A", 0) });
  EXPECT_TRUE(recon::StructureSetFile::IsStructureSet(this->Name("new.dcm")));
  EXPECT_EQ(this->NumberOfFiles(), 1u);
}

TEST_F(StructureSetFormatter, LeavesOutWhatIsNothingAndSaysSo)
{
  recon::WrittenROI roi = Square("A", 0);
  roi.Contours.push_back({ { { 0, 0, 0 }, { 1, 0, 0 } }, "CLOSED_PLANAR", "cell 1" });
  recon::WrittenROI empty;
  empty.Description.Name = "Empty";
  const std::vector<std::string> report = this->Write({ roi, empty });
  ASSERT_EQ(report.size(), 3u);
  EXPECT_EQ(
    report[0], "ROI \"A\", cell 1: left out, 2 points are no contour of type CLOSED_PLANAR.");
  EXPECT_EQ(report[1], "ROI \"Empty\": left out, it has no contours.");
  EXPECT_EQ(recon::StructureSetFile(this->Name("new.dcm")).GetROIs().size(), 1u);
}

TEST_F(StructureSetFormatter, OpenContoursThatAreNotPlanarAreWrittenAsThat)
{
  recon::WrittenROI roi = Square("A", 0);
  roi.Contours.push_back(
    { { { 0, 0, 0 }, { 5, 0, 0 }, { 5, 5, 0 }, { 5, 5, 5 } }, "OPEN_PLANAR", "cell 1" });
  const std::vector<std::string> report = this->Write({ roi });
  ASSERT_EQ(report.size(), 2u);
  EXPECT_EQ(report[0].rfind("ROI \"A\", cell 1: written as OPEN_NONPLANAR", 0), 0u) << report[0];
  recon::StructureSetFile file(this->Name("new.dcm"));
  EXPECT_EQ(file.ReadContours(0, this->Monitor).GeometricTypes,
    (std::vector<std::string>{ "CLOSED_PLANAR", "OPEN_NONPLANAR" }));
}

TEST_F(StructureSetFormatter, NoReferenceSlicesWithoutDrawnPlanes)
{
  // Series without images are not allowed, and left behind.
  StructureSetBuilder builder;
  FillReference(builder, {}, 0);
  builder.Save(this->Name("reference.dcm"));
  this->Options.Reference = this->Name("reference.dcm");
  this->Write({ Square("A", 0) });
  DcmItem& frame = *recon::ItemsOf(this->Load(), DCM_ReferencedFrameOfReferenceSequence).at(0);
  EXPECT_EQ(recon::GetText(frame, DCM_FrameOfReferenceUID), "1.2.3.9");
  EXPECT_TRUE(recon::ItemsOf(frame, DCM_RTReferencedStudySequence).empty());
}
