// SPDX-License-Identifier: GPL-3.0-or-later
#include "Readers/ReaderTesting.h"

#include "Common/ReplacedFile.h"

using namespace readertesting;

namespace
{
class ReplacedFile : public Folder
{
protected:
  void Fill(const recon::ReplacedFile& file) { std::ofstream(file.GetPart()) << "new"; }
  std::size_t NumberOfFiles() const
  {
    const std::filesystem::path folder = std::filesystem::path(this->Name("x")).parent_path();
    return static_cast<std::size_t>(std::distance(
      std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
  }
};
}

TEST_F(ReplacedFile, IsThereOnceItIsWhole)
{
  const std::string name = this->Write("a file", "old");
  {
    recon::ReplacedFile file(name);
    this->Fill(file);
    EXPECT_EQ(Bytes(name), "old");
    file.Commit();
  }
  EXPECT_EQ(Bytes(name), "new");
  EXPECT_EQ(this->NumberOfFiles(), 1u);
}

TEST_F(ReplacedFile, LeavesWhatWasThereOtherwise)
{
  const std::string name = this->Write("a file", "old");
  {
    const recon::ReplacedFile file(name);
    this->Fill(file);
  }
  EXPECT_EQ(Bytes(name), "old");
  EXPECT_EQ(this->NumberOfFiles(), 1u);
}

TEST_F(ReplacedFile, TwoOfOneNameHaveAPartEach)
{
  const recon::ReplacedFile one(this->Name("a file"));
  const recon::ReplacedFile other(this->Name("a file"));
  EXPECT_NE(one.GetPart(), other.GetPart());
}

TEST_F(ReplacedFile, OfALinkWhatItPointsToIsReplaced)
{
  const std::string name = this->Write("a file", "old");
  std::filesystem::create_symlink(name, this->Name("link"));
  recon::ReplacedFile file(this->Name("link"));
  this->Fill(file);
  file.Commit();
  EXPECT_EQ(Bytes(name), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(this->Name("link")));
}

TEST_F(ReplacedFile, FoldersAndDevicesAreRefused)
{
  const auto sentence = [](const std::string& name)
  { return SentenceOf([&] { const recon::ReplacedFile file(name); }); };
  ExpectSentence(sentence(this->Name("none/a")), "none/a", "there is no folder");
  ExpectSentence(sentence(this->Name("")), "Cannot write", "it is a folder");
  ExpectSentence(sentence("/dev/null"), "/dev/null", "it is a device");
}
