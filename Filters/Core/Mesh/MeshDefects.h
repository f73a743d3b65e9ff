// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file MeshDefects.h
 * @brief The faults of a triangle as bits, so that one cell array says all of them.
 */
#ifndef recon_MeshDefects_h
#define recon_MeshDefects_h

namespace recon
{
/**
 * Bits of the cell array `Defect`; 0 = nothing wrong here.
 *
 * Touching is not in itself wrong: surfaces that were cut apart into manifolds touch where they
 * were cut. It comes last, so that `Defect` below 512 and not 0 selects what is.
 */
enum TriangleDefect : int
{
  DefectOpenEdge = 1,        ///< one of its edges belongs to no other triangle
  DefectOverusedEdge = 2,    ///< one of its edges belongs to more than two triangles
  DefectMisorientedEdge = 4, ///< it runs along one of its edges in its neighbour's direction
  DefectPinchedVertex = 8,   ///< triangles around one of its corners form more than one fan
  DefectDuplicate = 16,      ///< another triangle has the same three corners
  DefectDegenerate = 32,     ///< its corners repeat or lie on one line
  DefectCrossing = 64, ///< its interior meets that of a triangle of another plane, or sheets cross
                       ///< at an edge of it
  DefectOverlapping = 128, ///< it shares some area with a triangle of the same plane
  DefectInward = 256,      ///< its component is closed and oriented, but inside out
  DefectTouching = 512     ///< meets another triangle elsewhere than in a corner or edge they share
};

/// All bits that say that something is wrong, which is all but DefectTouching.
constexpr int DefectAnyError = DefectTouching - 1;
}

#endif
