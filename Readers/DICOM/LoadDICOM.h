// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file LoadDICOM.h
 * @brief A DICOM file, from which nothing is taken that would end the program.
 *
 * DCMTK reads sequences within sequences by recursion: some thousand levels, 32 bytes each, use up the stack. And a
 * deflated data set of a hundred kilobytes may unpack to a hundred megabytes. Either ends in a sentence here.
 *
 * For the sources of this folder only, because it takes in DCMTK's headers.
 */
#ifndef recon_LoadDICOM_h
#define recon_LoadDICOM_h

// DCMTK's own order: its configuration comes first.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcdeftag.h>
#include <dcmtk/dcmdata/dcfilefo.h>

#include <string>

namespace recon
{
/// Bytes of stack that reading may take: some 180 levels, where DICOM's own objects have less than ten.
constexpr std::size_t MostStackOfDICOM = 256 << 10;
/// A deflated data set may be so many times as large as its file. Contours as text are about four times.
constexpr std::size_t MostInflationOfDICOM = 64;

/// A whole file but for its pixels, which nothing here is made of. What is written under that name later does not change it.
/// @throws Error where there is none, where it is no DICOM file or damaged, and beyond the limits above.
void LoadDICOM(const std::string& fileName, DcmFileFormat& file);

/// What comes before an element. @return why it cannot be read, which completes "FILE: "; empty where it can
std::string LoadDICOMUntil(
  const std::string& fileName, DcmFileFormat& file, const DcmTagKey& element);
}

#endif
