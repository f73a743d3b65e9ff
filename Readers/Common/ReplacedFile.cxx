// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/ReplacedFile.h"

#include "Base/Monitor.h"

#include <filesystem>
#include <random>

namespace recon
{
ReplacedFile::ReplacedFile(const std::string& fileName)
{
  namespace fs = std::filesystem;
  std::error_code status;
  fs::path path = fs::absolute(fileName, status);
  if (fs::is_symlink(path, status) && fs::exists(path, status))
  {
    path = fs::canonical(path, status); // what it points to is replaced, not the link
  }
  if (!fs::is_directory(path.parent_path(), status))
  {
    throw Error(
      "Cannot write " + fileName + ": there is no folder " + path.parent_path().string() + ".");
  }
  if (fs::is_directory(path, status))
  {
    throw Error("Cannot write " + fileName + ": it is a folder.");
  }
  if (fs::exists(path, status) && !fs::is_regular_file(path, status))
  {
    throw Error("Cannot write " + fileName + ": it is a device, not a file.");
  }
  this->FileName = path.string();
  // Random, so that two that write the same file at once do not share a part.
  const std::string part =
    "." + path.filename().string() + "." + std::to_string(std::random_device()()) + ".part";
  this->Part = (path.parent_path() / part).string();
}

ReplacedFile::~ReplacedFile()
{
  std::error_code ignored;
  std::filesystem::remove(this->Part, ignored);
}

void ReplacedFile::Commit()
{
  std::error_code status;
  std::filesystem::rename(this->Part, this->FileName, status);
  if (status)
  {
    throw Error("Cannot write " + this->FileName + ": " + status.message() + ".");
  }
}
}
