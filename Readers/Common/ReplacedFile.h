// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ReplacedFile.h
 * @brief A file that is written beside its name and renamed when it is whole.
 */
#ifndef recon_ReplacedFile_h
#define recon_ReplacedFile_h

#include <string>

namespace recon
{
/**
 * Writers write to GetPart() and end with Commit(); otherwise the part is removed again, and what
 * was there under the name is untouched. Both are in one folder, so renaming is atomic.
 */
class ReplacedFile
{
public:
  /// @throws Error where the folder does not exist, or the name is that of a folder.
  explicit ReplacedFile(const std::string& fileName);
  ~ReplacedFile();
  ReplacedFile(const ReplacedFile&) = delete;
  ReplacedFile& operator=(const ReplacedFile&) = delete;

  const std::string& GetPart() const { return this->Part; }
  /// @throws Error where the file cannot be renamed.
  void Commit();

private:
  std::string FileName;
  std::string Part;
};
}

#endif
