// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SVGParser.h
 * @brief Outlines of drawings (.svg), a drawing or a layer a slice, without VTK.
 *
 * Scalable Vector Graphics 1.1: path, polygon, polyline, line, rect, circle and ellipse, with the
 * transforms of their groups. Curves become pieces of line (SVGPath.h says how fine). Each closed
 * subpath is a contour; of a path that is open, the ends are left open. What is not drawn itself (defs,
 * clipPath, mask, marker, pattern, symbol) or not displayed is left out; so are text, images and
 * copies (use), with a line in Report.
 *
 * Several files are a slice each, in the order given. One file with several layers (groups that
 * Inkscape marks so) is a slice a layer, in the order of the file; without them it is one slice.
 *
 * x goes to the right and y down, as in the drawing; with slices along +z that is a right-handed frame.
 * Coordinates are user units times PixelSize. Where the drawing has a width in a length (mm, cm, in, pt,
 * pc) and a viewBox, they are millimetres times PixelSize.
 *
 * An element with a label of its own (inkscape:label) belongs to the object of that name, all others to
 * one object named after the first file.
 */
#ifndef recon_SVGParser_h
#define recon_SVGParser_h

#include "Base/Monitor.h"
#include "Common/SliceStack.h"
#include "Common/TracedFile.h"

#include <string>
#include <vector>

namespace recon
{
/// Whether the file is XML that begins with an element svg.
bool IsSVG(const std::string& fileName);

/// @throws Error with file and line where one of them is no drawing; Aborted.
TracedFile ReadSVG(
  const std::vector<std::string>& fileNames, const SliceStack& stack, Monitor& monitor);
}

#endif
