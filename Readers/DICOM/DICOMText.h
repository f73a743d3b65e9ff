// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file DICOMText.h
 * @brief Names as DICOM allows them (PS3.5 6.2). Texts are UTF-8.
 */
#ifndef recon_DICOMText_h
#define recon_DICOMText_h

#include <cstddef>
#include <string>
#include <string_view>

namespace recon
{
bool IsASCII(std::string_view text);
/// Whether all bytes are UTF-8 (RFC 3629).
bool IsUTF8(std::string_view text);

/// Of at most so many characters, with '_' for backslashes, control characters and bytes that are
/// no UTF-8; without spaces at the ends.
std::string DICOMText(const std::string& text, std::size_t longest);

/// A code string: at most 16 of A-Z, 0-9, space and underscore; lower case becomes upper case, the
/// rest '_'.
std::string CodeString(const std::string& text);
}

#endif
