// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SolidBoundary.h
 * @brief The boundary of the solid as a closed manifold.
 *
 * A face of one kept tetrahedron only is surface, so the surface is closed and oriented by
 * construction and the horizontal caps (thesis 6.4) come out by themselves. Where the solid touches
 * itself in an edge or a vertex (thesis 11.2.2, figure 11.3), the boundary is cut apart: the faces
 * of one wedge of solid stay together and each wedge gets points of its own. Which faces these are
 * is found by turning around the edge through the tetrahedra, so no coordinate decides it.
 */
#ifndef recon_SolidBoundary_h
#define recon_SolidBoundary_h

#include "Polyhedral/SolidComplex.h"

#include <array>
#include <vector>

namespace recon
{
struct SolidBoundary
{
  struct Point
  {
    int Vertex; ///< index into SolidComplex::Vertices
    int
      OtherVertex; ///< -1, or the other end of an edge that was halved: the point is in its middle
  };

  struct Face
  {
    std::array<int, 3> Points; ///< counterclockwise seen from outside
    int Cell;                  ///< the tetrahedron behind it
    int Opposite;              ///< vertex of the tetrahedron that does not belong to the face
  };

  /// A face of which edges were halved: the first of its pieces took its place, the others stand after all
  /// faces, piece by piece and face by face; middles stand after all other points.
  struct Split
  {
    int Face;
    std::array<int, 3> Whole; ///< the corners that it had
    int End;                  ///< of its other pieces, which begin where those before it end
  };

  std::vector<Point> Points; ///< in the order in which faces name them
  std::vector<Face> Faces;   ///< by cell, but for pieces
  std::vector<Split> Splits; ///< by face
  int WholeFaces = 0;        ///< the others are pieces of these
};

SolidBoundary ExtractSolidBoundary(const SolidComplex& solid);
}

#endif
