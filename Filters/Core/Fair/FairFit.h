// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file FairFit.h
 * @brief An even mesh moved to where it bends least, within a tolerance of contour samples.
 */
#ifndef recon_FairFit_h
#define recon_FairFit_h

#include "Base/Monitor.h"
#include "Fair/ContourSamples.h"
#include "Fair/FairSystem.h"
#include "Fair/SurfacePlaces.h"

#include <cstddef>
#include <vector>

namespace recon
{
struct FairFitOptions
{
  double Tolerance = 0;     ///< in the units of the input
  double EdgeLength = 1;    ///< of the mesh
  double Scale = 1;         ///< length of what is bridged: the distance of slices
  double Weight = 1;        ///< of pulls, see FairSystem; those that miss get more
  double MostWeight = 1;    ///< of those of contours smaller than the scale, or Weight
  std::vector<double> Kept; ///< a point of the mesh, see FairSystem
  int Threads = 0;
};

struct FairSolution
{
  std::vector<Point3> Points; ///< places of the mesh's points
  double Tension = 0;         ///< mean of the points
};

/// How far the vertices among samples are from a mesh.
struct SampleMisfit
{
  double Farthest = 0;
  std::size_t Beyond = 0; ///< farther away than a tolerance
};

SampleMisfit MeasureMisfit(const TriangleMesh& mesh, const std::vector<ContourSample>& samples,
  double tolerance, int threads, Monitor& monitor);

/// The pulls of samples at the places of the mesh nearest to them; those that have none within some
/// edge lengths are passed over. Contours smaller than the scale pull more: a bump's bending grows as its
/// size becomes smaller, and what pulls at it becomes less.
std::vector<Pull> PullsOf(const SurfacePlaces& surface, const std::vector<ContourSample>& samples,
  const FairFitOptions& options, Monitor& monitor);

/**
 * Solves, and again a few times: over the mesh that came out, whose lengths are nearer to those of the
 * surface that is looked for than terraces are; with pulls at the places that are nearest by then, so
 * that the surface may slide along itself; and with more weight where it is farther than the tolerance.
 *
 * @param tension of all points; negative: of each its own, as TensionByBend says of the first solution
 * @throws Error, Aborted
 */
FairSolution SolveWithin(const TriangleMesh& mesh, std::vector<Pull>& pulls, double tension,
  const FairFitOptions& options, Monitor& monitor);

struct PulledMesh
{
  TriangleMesh Mesh;
  bool IsWithin = false; ///< every vertex is known to be within the tolerance
};

/**
 * Moves the corners of the triangles that vertices among the samples are farther away from than the
 * tolerance by as little as takes them there, in turn, a few times (Kaczmarz). Nothing crosses by it,
 * and no angle becomes small.
 */
PulledMesh PullWithin(const TriangleMesh& mesh, const std::vector<ContourSample>& samples,
  const FairFitOptions& options, Monitor& monitor);
}

#endif
