// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ImageJParser.h
 * @brief ROIs of ImageJ: one (.roi), or a set as the ROI Manager saves it (.zip), without VTK.
 *
 * The format is that of ImageJ's class ij.io.RoiDecoder: big-endian, 64 bytes of header that begin
 * with "Iout", coordinates, and a second header with the place in the stack and the name. Polygons,
 * freehand and traced outlines, rectangles, ovals and composite outlines are closed; lines are open;
 * points are points.
 *
 * x goes to the right and y down, as in the image; with slices along +z that is a right-handed frame,
 * as DICOM's is. The slice is the ROI's position in the stack (1 is the first), or, where it has none,
 * the first number of a name such as 0012-0345-0678, which ImageJ gives by itself.
 *
 * All ROIs are outlines of one object, unless they are in groups: then a group is an object.
 */
#ifndef recon_ImageJParser_h
#define recon_ImageJParser_h

#include "Base/Monitor.h"
#include "Common/SliceStack.h"
#include "Common/TracedFile.h"

#include <string>

namespace recon
{
/// Whether the file begins as an ROI does, or is a .zip that begins with one named so.
bool IsImageJ(const std::string& fileName);

/// A damaged ROI of a set is left out with a line in Report.
/// @throws Error where nothing can be read; Aborted.
TracedFile ReadImageJ(const std::string& fileName, const SliceStack& stack, Monitor& monitor);
}

#endif
