// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Shapes.h
 * @brief Closed meshes cut by planes, so that what is made of the sections can be laid beside the truth.
 */
#ifndef recon_Shapes_h
#define recon_Shapes_h

#include "Contours/ContourSet.h"
#include "Mesh/TriangleMesh.h"

#include <string>

namespace recon::shapes
{
/// An .off file of triangles. @throws Error
TriangleMesh ReadOFF(const std::string& path);

/// Sections of so many equal slices along an axis, as loose segments.
/// @param phase where in its slice a section lies: 0.5, in the middle
LoopSoup Cut(const TriangleMesh& mesh, int axis, int slices, double phase);

struct Deviation
{
  double Mean = 0; ///< half of it from either way
  double Largest = 0;
};
/// Between two surfaces, at points spread evenly over each by area, the same ones every time.
Deviation Compare(const TriangleMesh& one, const TriangleMesh& other);

/// Of a closed mesh.
int EulerOf(const TriangleMesh& mesh);
double VolumeOf(const TriangleMesh& mesh);
}

#endif
