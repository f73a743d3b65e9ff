// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file DICOMTextConversion.h
 * @brief All texts of an item in UTF-8, so that texts of other files can stand beside them.
 *
 * For the sources of this folder only, because it takes in DCMTK's headers.
 */
#ifndef recon_DICOMTextConversion_h
#define recon_DICOMTextConversion_h

#include "DICOM/DICOMItem.h"

#include <string>
#include <vector>

namespace recon
{
/// Converts the item and all below it, and says so in Specific Character Set (0008,0005).
/// @return the names of elements with bytes that their character set does not explain; these are
/// '?' then
std::vector<std::string> ConvertToUTF8(DcmItem& item);
}

#endif
