// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ZIPFile.h
 * @brief The files within a ZIP archive (PKWARE's APPNOTE), stored or deflated.
 */
#ifndef recon_ZIPFile_h
#define recon_ZIPFile_h

#include "Base/Monitor.h"

#include <functional>
#include <string>
#include <vector>

namespace recon
{
/// Whether the bytes begin as an archive with at least one file does.
bool IsZIP(const std::string& start);

/**
 * Gives each file of an archive, in the order of its directory: its name, and what is in it.
 *
 * A file that cannot be unpacked (damaged, encrypted, of another method than deflate, larger than
 * 256 MB) is a sentence in the report, and costs itself only.
 *
 * @throws Error where the archive has no directory, or one that is no such thing; where its files share bytes, or
 * unpack to more than 64 times its size
 */
void ReadZIP(const std::string& fileName, const std::string& bytes,
  const std::function<void(const std::string& name, const std::string& content)>& take,
  std::vector<std::string>& report, Monitor& monitor);
}

#endif
