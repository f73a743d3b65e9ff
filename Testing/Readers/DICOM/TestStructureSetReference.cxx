// SPDX-License-Identifier: GPL-3.0-or-later
#include "Readers/DICOM/ReferenceBuilder.h"
#include "Readers/ReaderTesting.h"

#include "DICOM/StructureSetReference.h"

using namespace readertesting;

namespace
{
class StructureSetReference : public Folder
{
protected:
  std::string Save(StructureSetBuilder& builder)
  {
    builder.Save(this->Name("set.dcm"));
    return this->Name("set.dcm");
  }
  recon::Monitor Monitor;
};
}

TEST_F(StructureSetReference, NoneTakesEveryFrame)
{
  recon::StructureSetReference none;
  EXPECT_TRUE(none.IsNone());
  EXPECT_TRUE(none.HasFrame("1.2.3"));
  EXPECT_EQ(none.FrameFor("1.2.3"), "1.2.3");
  EXPECT_EQ(none.FrameFor(""), none.GetFrames().front());
  EXPECT_TRUE(none.GetSlices("1.2.3").GetSlices().empty());
  EXPECT_FALSE(none.IsPartOfIt("/"));
  DcmItem data;
  none.AddImagesTo(data, { "1.2.3", "1.2.4" });
  EXPECT_EQ(recon::ItemsOf(data, DCM_ReferencedFrameOfReferenceSequence).size(), 2u);
}

TEST_F(StructureSetReference, FramesOfROIsAreThoseOfTheSet)
{
  StructureSetBuilder builder;
  FillReference(builder, { 0, 1 }, 2);
  DcmItem* roi = nullptr;
  builder.Data().findAndGetSequenceItem(DCM_StructureSetROISequence, roi, 0);
  StructureSetBuilder::Put(*roi, DCM_ReferencedFrameOfReferenceUID, "1.2.3.10"); // is not listed
  recon::StructureSetReference set(this->Save(builder), this->Monitor);
  EXPECT_TRUE(set.IsStructureSet());
  EXPECT_EQ(set.GetFrames(), (std::vector<std::string>{ "1.2.3.9", "1.2.3.10" }));
  EXPECT_TRUE(set.HasFrame("1.2.3.10"));
  EXPECT_FALSE(set.HasFrame("1.2.3.11"));
  EXPECT_TRUE(set.GetSlices("1.2.3.9").GetSlices().empty());
  EXPECT_EQ(set.GetSlices("1.2.3.10").GetSlices().size(), 2u);
  EXPECT_NE(set.WhyNotIn("1.2.3.11").find("1.2.3.9 and 1.2.3.10"), std::string::npos);
  DcmItem data;
  set.AddImagesTo(data, { "1.2.3.10" });
  EXPECT_EQ(recon::ItemsOf(data, DCM_ReferencedFrameOfReferenceSequence).size(), 2u);
}

TEST_F(StructureSetReference, WithoutFrameHasOneOfItsOwn)
{
  StructureSetBuilder builder;
  FillReference(builder, { 0, 1 }, 2);
  ASSERT_TRUE(builder.Data().findAndDeleteElement(DCM_ReferencedFrameOfReferenceSequence).good());
  const recon::StructureSetReference set(this->Save(builder), this->Monitor);
  ASSERT_EQ(set.GetFrames().size(), 1u);
  EXPECT_TRUE(set.HasFrame("1.2.3"));
  EXPECT_EQ(set.FrameFor("1.2.3"), set.GetFrames().front());
  EXPECT_EQ(set.GetSlices(set.FrameFor("1.2.3")).GetSlices().size(), 2u);
  ASSERT_EQ(set.GetReport().size(), 1u);
  EXPECT_NE(set.GetReport()[0].find("no frame of reference"), std::string::npos);
}

TEST_F(StructureSetReference, ImagesArePartOfIt)
{
  std::filesystem::create_directory(this->Name("images"));
  for (int slice = 0; slice < 3; ++slice)
  {
    SaveImage(this->Name("images/" + std::to_string(slice)), slice);
  }
  const recon::StructureSetReference images(this->Name("images/1"), this->Monitor);
  EXPECT_FALSE(images.IsStructureSet());
  EXPECT_EQ(images.GetFrames(), std::vector<std::string>{ "1.2.3.9" });
  EXPECT_TRUE(images.IsPartOfIt(this->Name("images/../images/2")));
  EXPECT_FALSE(images.IsPartOfIt(this->Name("new.dcm")));
}
