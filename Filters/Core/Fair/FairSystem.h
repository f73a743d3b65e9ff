// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file FairSystem.h
 * @brief Moves the points of a mesh to where it bends least, pulled to given places.
 */
#ifndef recon_FairSystem_h
#define recon_FairSystem_h

#include "Base/Monitor.h"
#include "Fair/SurfacePlaces.h"
#include "Mesh/TriangleMesh.h"

#include <memory>
#include <vector>

namespace recon
{
/// A place of the mesh, and where it should be.
struct Pull
{
  SurfacePlace From;
  Point3 To;
  Vector3 Outward; ///< unit, the side of the surface that faces there
  double Weight;   ///< of the squared distance, per cube of the scale
};

/// Of a point where the surface bends as it likes, as on the rim of a flat end.
constexpr double Crease = 2;

/**
 * @class FairSystem
 * @brief Thin plate and membrane over a mesh (Botsch and Kobbelt 2004), solved by a sparse Cholesky
 * factorisation.
 *
 * With x the places of the points, x0 those at rest, k how much of it is kept, h the scale and t the tension, which may
 * differ from point to point, it makes
 *
 *     ∫(1 - t) |Δx - k Δx0 - (1 - k) b n|² + s / h² ∫t |∇(x - x0)|² + Σ Weight / h³ |x(From) - To|²
 *
 * least. Δ is the Laplacian (cotangents) of the mesh in a given shape. t = 1 leaves the points at rest
 * as far as pulls allow. The order of the unknowns is found once, for any number of shapes.
 *
 * b is how much the surface bends, n its normal. A plate at first, b = 0, which is too flat wherever nothing pulls: the
 * least that a ball can bend is to be no ball. Then, a few times, b is the bend (along n) of the surface
 * found before, evened out: what is looked for bends evenly rather than little (as surfaces of least
 * variation of curvature, Moreton and Sequin 1992), so that a ball stays a ball, and an end goes on as
 * round as what leads to it. Each time costs a solution, but no factorisation.
 */
class FairSystem
{
public:
  /// @param mesh at rest, x0; outlives this @param kept a point: how much of its bend at rest it keeps,
  /// from 0 to 1, and Crease where it bends as it likes; or empty @param scale length of what is
  /// bridged: the distance of slices
  FairSystem(const TriangleMesh& mesh, const std::vector<double>& kept, double scale, int threads,
    Monitor& monitor);
  ~FairSystem();
  FairSystem(const FairSystem&) = delete;
  FairSystem& operator=(const FairSystem&) = delete;

  /// The points' new places. @param shape places of the points whose lengths and angles count
  /// @param tension a point @param evenings so many times the bend is evened out; 0: a plate
  /// @throws Error where the equations have no answer; Aborted
  std::vector<Point3> Solve(const std::vector<Point3>& shape, const std::vector<Pull>& pulls,
    const std::vector<double>& tension, int evenings);

  /// How much a mesh in this shape bends at its points: the length of Δx, the sum of both curvatures; 0
  /// where it bends as it likes. In units of one by the scale.
  std::vector<double> BendOf(const std::vector<Point3>& shape);

private:
  struct Implementation;
  std::unique_ptr<Implementation> Impl;
};
}

#endif
