// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file CrossingGuard.h
 * @brief Keeps the triangles of a mesh that is edited from crossing one another.
 */
#ifndef recon_CrossingGuard_h
#define recon_CrossingGuard_h

#include "Base/Monitor.h"
#include "Implicit/ZeroSet/EditableMesh.h"
#include "Implicit/ZeroSet/TriangleGrid.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace recon
{
/// Points near which another sheet of the surface is: what lies nearer than `radius`, with a normal
/// that turns another way.
std::vector<char> ThinPlaces(
  const std::vector<Point3>& points, const std::vector<Vector3>& normals, double radius);

/// Points around the triangles that cross or overlap others are thin from now on. @returns how many
/// pairs do. @param crossed what became of a mesh with these points @throws Aborted
std::int64_t MarkCrossings(const TriangleMesh& crossed, const std::vector<Point3>& points,
  double radius, int threads, Monitor& monitor, std::vector<char>& thin);

/**
 * @class CrossingGuard
 * @brief Says of a changed triangle whether it crosses another one.
 *
 * It listens to the mesh's changes from its first question on; until then it costs nothing.
 */
class CrossingGuard
{
public:
  /// @param thin a point: whether changes there are looked at. All outlive this, and this is not
  /// moved. @param cell of the grid of triangles, some edges long
  CrossingGuard(
    TriangleMesh& mesh, EditableMesh& edited, const std::vector<char>& thin, double cell);
  ~CrossingGuard();
  CrossingGuard(const CrossingGuard&) = delete;
  CrossingGuard& operator=(const CrossingGuard&) = delete;

  bool IsThin(const EditableMesh::Triangle& t) const
  {
    return this->Thin[t[0]] || this->Thin[t[1]] || this->Thin[t[2]];
  }
  bool AnyThin(const EditableMesh::Changes& before) const;

  bool Crosses(int t);
  /// Takes a change back where a changed triangle crosses another one. @returns whether it stays.
  bool KeepUncrossed(const EditableMesh::Changes& before);

private:
  void Register(int t);

  const TriangleMesh& Mesh;
  EditableMesh& Edited;
  const std::vector<char>& Thin;
  double Cell;
  std::unique_ptr<TriangleGrid> Grid; ///< made when it is first needed
};
}

#endif
