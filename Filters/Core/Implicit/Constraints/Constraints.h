// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Constraints.h
 * @brief From contours to places where the value of the implicit function is known (thesis 9.1,
 * algorithm 13).
 *
 * Notation:
 *   c_i  location, h_i value: 0 on a contour, > 0 inside, < 0 outside the solid
 *   d    margin distance, in the units of the input
 */
#ifndef recon_Constraints_h
#define recon_Constraints_h

#include "Base/Monitor.h"
#include "Contours/ContourSet.h"

#include <string>
#include <vector>

namespace recon
{
/// A plane on which nothing was drawn, though others of the same stack were: it is empty.
struct EmptyPlane
{
  Vector3 Normal{ 0, 0, 1 }; ///< unit
  double Offset = 0;         ///< along Normal
};

/// What makes a disagreement worth constraints. Lengths are parts of a cell, areas of what is drawn.
struct SectionTolerances
{
  double Depth = 1;    ///< a place so far from all contours of its plane is on the wrong side
  double Area = 0.015; ///< so much of a plane's drawn area is, in all
  /// A hole or an island that nobody drew has so much, in cells; a smaller one cannot be seen.
  double Island = 0.25;
  double Lost = 0.5;      ///< so much of a drawn contour's area is on the other side: it is lost
  double WaistArea = 0.3; ///< so much of a hole, or of a branch, is filled, or gone, between planes
};

struct ConstraintOptions
{
  enum ModeType
  {
    Margins = 0,           ///< thesis 9.1: n boundary, n inner and n outer constraints
    BoundingBoxCorners = 1 ///< thesis 10.3: n boundary constraints and the 8 corners, outside
  };
  enum ValuesType
  {
    Unit = 0,    ///< thesis: +1 and -1
    Distance = 1 ///< the signed distance to the contour (corners: to its nearest vertex)
  };
  enum NormalsType
  {
    InPlane = 0, ///< thesis: margins in the plane of the contour
    Refined = 1  ///< margins along the normals of a first fit (RefinedMargins.h)
  };

  ModeType Mode = Margins;
  ValuesType Values = Distance;
  NormalsType Normals = Refined;
  /// d; 0 = a third of the median length of a contour edge: nearer in, the system's condition grows
  /// as d^-3; further out, margins would speak for places that the next vertex knows better.
  double MarginDistance = 0;
  /// Where all planes are parallel and the next one says otherwise of a place as far from the
  /// contour as it is itself, the margin goes there (Values Distance only): the surface lies flat
  /// there, as on the end of a brain stem whose slices are few. Not always, as it is less true
  /// where the surface is round; left-out slices tell (ContourFit.h).
  bool ReachAcrossSteps = false;
  /// Thesis 9.1: points of crossing planes that fit in a box of this part of the bounding box
  /// become their centroid. The thesis uses 0.05; 0 = none.
  double MergeBox = 0;
  /// Leave out contour points that stand closer than the gap between the contours is worth
  /// (ContourResampling.h); the others stay where they are. Not where one of the next two is given.
  bool ThinOut = true;
  /// > 0: contours are first resampled to about this distance between points (units of the input).
  double ResampleSpacing = 0;
  /// > 0: contour points are first left out where the contour moves by less than this (units of the
  /// input).
  double ResampleTolerance = 0;
  /// Put points on straight edges longer than twice the gap between the contours (ContourResampling.h):
  /// constraints stand at points alone. Not where one of the two above is given.
  bool FillLongEdges = true;
  /// Where all planes are parallel and values are distances: add constraints where the function is
  /// on another side than what was drawn (DrawnSections.h), until it is not, as far as that goes.
  bool FollowDrawnPlanes = true;
  SectionTolerances Sections; ///< of FollowDrawnPlanes
  /// Further planes on which nothing was drawn, though it was looked at: for FollowDrawnPlanes.
  std::vector<EmptyPlane> EmptyPlanes;
};

struct ConstraintSet
{
  enum KindType
  {
    Boundary = 0,
    Inner = 1,
    Outer = -1
  };

  std::vector<Point3> Points;
  std::vector<double> Values;
  std::vector<int> Kind;     ///< KindType
  std::vector<int> Contour;  ///< index into ContourSet::Contours; -1 for a corner or a merged point
  double MarginDistance = 0; ///< the d that was used, before it was shrunk locally
  std::size_t LeftOut = 0;   ///< constraints that 3n, or n + 8, would have beside these
  std::vector<std::string> Report; ///< a sentence for everything shrunk away, merged or resampled
};

/**
 * Exactly 3n constraints for n contour vertices (n + 8 with the corners), boundary, inner and outer
 * in turn, but for those that Report names. A margin point is nearer to the edges at its own vertex
 * than to any other edge of its level, on its proper side of all of them (decided exactly); where
 * the shape is thin it is moved nearer to its vertex until it is, and left out where that leaves it
 * nearer than a fit can tell apart (NearConstraints.h). One that reaches across a step is
 * on its proper side of all edges, and at least 0.8 of its reach from all of them.
 *
 * Inner is towards the solid: for the wall of a hole it is the hole's outer side (12.2).
 *
 * @throws Error where all contours lie in one plane, or an option makes no sense; Aborted.
 */
ConstraintSet BuildInPlaneConstraints(
  const ContourSet& contours, const ConstraintOptions& options, Monitor& monitor);

/// Are all planes parallel, so that levels lie next to one another and margins can reach across
/// steps?
bool AllLevelsParallel(const ContourSet& contours);

/// The d that options ask for on these contours.
double ChooseMarginDistance(const ContourSet& contours, const ConstraintOptions& options);

/// @throws Error as BuildInPlaneConstraints does.
void CheckConstraintInput(const ContourSet& contours, const ConstraintOptions& options);
}

#endif
