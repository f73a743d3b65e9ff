// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file TurnedBoxes.h
 * @brief Boxes of triangles along the axes of another frame.
 */
#ifndef recon_TurnedBoxes_h
#define recon_TurnedBoxes_h

#include "Mesh/TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace recon
{
/// A tree of the boxes that triangles have in a frame, grown by what turning them into it rounds.
class TurnedBoxes
{
public:
  TurnedBoxes(const TriangleMesh& mesh, const PlanarFrame& frame)
    : Frame(frame),
      Turned(mesh),
      Tree((this->Turn(), this->Turned))
  {
  }

  /// Calls visit(i) for every triangle that may come nearer to triangle t than `distance`, if those
  /// are where they were and t is where it is now.
  template <typename Visitor>
  void VisitNear(const TriangleMesh& mesh, int t, double distance, const Visitor& visit) const
  {
    Box3 box;
    for (const int p : mesh.Triangles[static_cast<std::size_t>(t)])
    {
      box.Add(this->ToFrame(mesh.Points[p]));
    }
    this->Tree.VisitMeeting(box.Grown(distance + 2 * this->Rounding), visit);
  }

private:
  /// Turning a point into another frame rounds by less than this many steps of its largest coordinate.
  static constexpr double TurnInSteps = 16;

  Point3 ToFrame(const Point3& p) const
  {
    const Point2 planar = this->Frame.ToPlane(p);
    return { planar[0], planar[1], this->Frame.OffsetOf(p) };
  }

  void Turn()
  {
    double largest = 0;
    for (Point3& p : this->Turned.Points)
    {
      largest = std::max({ largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
      p = this->ToFrame(p);
    }
    this->Rounding = TurnInSteps * std::numeric_limits<double>::epsilon() * largest;
  }

  PlanarFrame Frame;
  double Rounding = 0;
  TriangleMesh Turned;
  TriangleTree Tree;
};
}

#endif
