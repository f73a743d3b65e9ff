// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SurfaceTest.h
 * @brief Whether poly data are a surface, which somebody forgot to cut, and no contours.
 */
#ifndef SurfaceTest_h
#define SurfaceTest_h

class vtkPolyData;

namespace recon
{
constexpr const char* SurfaceSentence =
  "The input is a surface, not contours: cut it with Slice first.";

/**
 * Whether most polygons belong to sheets that are not flat. A sheet is polygons that share edges,
 * also where each has points of its own (as an STL has); contours of one plane may share edges, as
 * those of a label map do, but stay in their plane.
 */
bool IsSurface(vtkPolyData* data);
}

#endif
