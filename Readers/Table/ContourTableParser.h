// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourTableParser.h
 * @brief Tables of points (.csv, .tsv, .txt), a row a point of a closed contour, without VTK.
 *
 * @code
 * object,slice,contour,x,y,z        a first line with names, in any order and case; or none
 * Femur,12,1,143.5,20.25,36
 * @endcode
 *
 * Columns are separated by commas, semicolons, tabs or spaces; where it is not by commas, numbers may
 * have decimal commas. Lines that begin with '#' are comments.
 *
 * | column | names | without it |
 * |---|---|---|
 * | x, y | x, y; also with a unit behind: "x (mm)", "X_um" | columns 1 and 2 |
 * | z | z | from the slice: its number times SliceStack::Spacing |
 * | slice | slice, section, plane, level, frame | a new one where z changes |
 * | contour | contour, contour_id, loop, polygon, polyline, curve, id | see below |
 * | object | object, name, label, structure, roi, region, material, layer | one object |
 *
 * Without a first line of names columns are x, y, z, and then, where there are more, contour and slice.
 *
 * Rows of one contour follow each other. A new one begins where object, slice or contour change; without
 * a column for contours also behind an empty line, where z changes, and behind a point that is the
 * contour's first again. Where a contour number goes on over several z with three rows or more at each,
 * its numbers are taken to begin anew on each slice.
 */
#ifndef recon_ContourTableParser_h
#define recon_ContourTableParser_h

#include "Base/Monitor.h"
#include "Common/SliceStack.h"
#include "Common/TracedFile.h"

#include <string>

namespace recon
{
/// Whether the file begins with names of columns that make contours: x and y, and a slice or contour.
bool IsContourTable(const std::string& fileName);

/// @throws Error with file and line where a row is none; Aborted.
TracedFile ReadContourTable(const std::string& fileName, const SliceStack& stack, Monitor& monitor);
}

#endif
