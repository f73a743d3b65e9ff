// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file VoronoiSkeleton.h
 * @brief The Voronoi skeletons of a level without the branches that are rounding only.
 *
 * The Voronoi vertex of a triangle is the centre of a circle that holds no vertex of the level. Of
 * points that were drawn on a circle it is the circle's centre for every triangle; once their
 * decimals are cut, branches run from there to everywhere, and an end that is lifted at each of
 * their vertices is another shape: a cylinder whose flat ends taper over 2% of its volume had 5% of
 * it there. Yet the circles of such a branch stick out of the one in the middle by no more than the
 * points were moved.
 */
#ifndef recon_VoronoiSkeleton_h
#define recon_VoronoiSkeleton_h

#include "Polyhedral/LevelTriangulation.h"

#include <vector>

namespace recon
{
/**
 * The unit of the last decimal that the points of a level's contours have; 0 where they have as
 * many as fit.
 *
 * One number in twenty may have more, as crossings that had to be computed do. A coordinate that
 * all points share is that of the plane, and does not count.
 */
double UnitOfLevel(const ContourSet& contours, int level);

/**
 * Of every triangle whether its Voronoi vertex belongs to the internal skeleton: it is finite, the
 * triangle lies in IR, and its circle is on no branch that rounding explains: one that sticks out of
 * the larger circle that it begins at by less than two units.
 *
 * unit: of the last decimal of the points, which are off by half of it along each axis; 0 keeps all.
 * But never is a branch left out that sticks out by a twentieth of the larger circle's radius, as
 * whole numbers may be meant exactly.
 */
std::vector<unsigned char> FindInternalSkeleton(const LevelTriangulation& level, double unit);

/// Its vertices, rounded; without repetitions, in a fixed order.
std::vector<Point2> InternalSkeletonVertices(const LevelTriangulation& level, double unit);

/// The same in ER.
std::vector<Point2> ExternalSkeletonVertices(const LevelTriangulation& level, double unit);
}

#endif
