// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file StructureSetCheck.h
 * @brief What DICOM asks of the contours of an ROI (PS3.3 C.8.8.6), before they are written.
 */
#ifndef recon_StructureSetCheck_h
#define recon_StructureSetCheck_h

#include "DICOM/StructureSetFormatter.h"

#include <string>
#include <vector>

namespace recon
{
/**
 * Leaves out what has too few points, and makes the types of an ROI agree.
 *
 * @param exclusiveOr whether closed contours become CLOSEDPLANAR_XOR
 * @param report takes a sentence for everything that was left out or changed
 * @throws Error where a coordinate is no number or beyond 100 km, or a closed contour is not planar
 */
void CheckContours(WrittenROI& roi, bool exclusiveOr, std::vector<std::string>& report);
}

#endif
