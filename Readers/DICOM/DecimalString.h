// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file DecimalString.h
 * @brief Coordinates as DICOM writes them (VR DS, PS3.5 6.2): decimal text of at most 16
 * characters.
 */
#ifndef recon_DecimalString_h
#define recon_DecimalString_h

#include <string>

namespace recon
{
/// Beyond this (100 km) six decimals do not fit.
constexpr double LargestCoordinate = 99999999;

/**
 * Appends the value, mm, rounded to six decimals without trailing zeros: within 5e-7 mm of it, and
 * exactly it where it was read from a file with no more decimals.
 *
 * @pre finite, and at most LargestCoordinate in size
 */
void AppendDecimalString(std::string& text, double value);
}

#endif
