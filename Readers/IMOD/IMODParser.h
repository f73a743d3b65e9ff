// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file IMODParser.h
 * @brief Models of IMOD (.mod): objects traced on the sections of an electron tomogram, without VTK.
 *
 * The binary format, "IMOD Binary File Format, Version 1.2" in IMOD's documentation: chunks of big-endian
 * numbers. Of them these are read:
 *
 * @code
 * "IMODV1.2"  header: scale of z, pixel size and its unit
 * "OBJT"      name, colour, whether its contours are open (bit 3) or scattered points (bit 9)
 * "CONT"      points x y z in pixels, whether it is open (bit 3)
 * "IEOF"      the end
 * @endcode
 *
 * Coordinates are pixels times the pixel size, z times the scale of z as well: the size that IMOD itself
 * measures. The image's own origin (chunk MINX) is not added. Meshes are left aside: they are made
 * of the contours.
 */
#ifndef recon_IMODParser_h
#define recon_IMODParser_h

#include "Base/Monitor.h"
#include "Common/TracedFile.h"

#include <string>

namespace recon
{
/// Whether the file begins as a binary IMOD model does.
bool IsIMOD(const std::string& fileName);

/// @throws Error with file and place where it is not whole; Aborted.
TracedFile ReadIMOD(const std::string& fileName, Monitor& monitor);
}

#endif
