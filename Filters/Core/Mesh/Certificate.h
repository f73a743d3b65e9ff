// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Certificate.h
 * @brief All figures that say what a surface is worth, a component and in total.
 *
 * For the meaning and the formula of each see MeshTopology.h, SelfIntersections.h, MassProperties.h
 * and SectionComparison.h; for the names under which they are written out, CertificateText.h.
 */
#ifndef recon_Certificate_h
#define recon_Certificate_h

#include "Base/Monitor.h"
#include "Contours/ContourSet.h"
#include "Contours/VolumeInterval.h"
#include "Mesh/MassProperties.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SectionComparison.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/SheetCrossings.h"
#include "Mesh/TriangleMesh.h"

#include <optional>
#include <vector>

namespace recon
{
/// The figures of one component, or of the whole surface.
struct ComponentCertificate
{
  TopologyFigures Topology;
  PairCounts Pairs;      ///< of triangles; for a component those with at least one triangle of it
  int CrossingEdges = 0; ///< see SheetCrossings; for a component those at which a triangle of it is
  MassFigures Mass;
  int Nesting = 0; ///< number of closed components around it; for the whole the deepest of them

  /// Closed, manifold, oriented outward, no two triangles cross or overlap, no two sheets cross.
  bool IsSound() const
  {
    return this->Topology.Closed && this->Topology.Manifold() && this->Topology.Oriented &&
      this->Topology.Outward && this->Pairs.Crossing + this->Pairs.Overlapping == 0 &&
      this->CrossingEdges == 0;
  }
};

struct SurfaceCertificate
{
  std::vector<ComponentCertificate> Components; ///< in the order of their first triangle
  ComponentCertificate Total;
  /**
   * The whole with points of equal coordinates taken for one, as a format without connectivity
   * (STL) would hand it on. A surface that was cut apart into a manifold has overused edges and
   * pinched vertices here.
   */
  TopologyFigures Welded;

  std::vector<SectionDifference> Sections; ///< a level; empty without contours
  std::optional<ContourDistance> Distance; ///< empty without contours or without a surface
  /// What the contours say, whatever the surface is; not by Certify, which takes contours in any
  /// planes. Empty without contours on two parallel planes or more.
  std::optional<VolumeInterval> Drawn;
  /// The largest difference of a level in percent; empty without contours, or where the surface is
  /// open at a level.
  std::optional<double> WorstSectionPercent() const;
  /// That of all levels together, in percent of all contours' area.
  std::optional<double> TotalSectionPercent() const;

  std::vector<int> DefectOfTriangle;    ///< TriangleDefect bits
  std::vector<int> ComponentOfTriangle; ///< -1 for a collapsed triangle that no other touches
  std::vector<IntersectingPair> Pairs;  ///< see SelfIntersections::Pairs
};

struct CertificateOptions
{
  /// Judge the surface with points of equal coordinates taken for one, not by its own connectivity.
  bool Weld = false;
  int Threads = 0; ///< 0 = as many as the machine has; the result does not depend on it
  double CoordinateRounding = 0; ///< see SectionOptions
};

/**
 * @param contours what the surface was made from, or nullptr
 * @throws Error where an index is out of range or a coordinate is not finite; Aborted.
 */
SurfaceCertificate Certify(const TriangleMesh& mesh, const ContourSet* contours,
  const CertificateOptions& options, Monitor& monitor);
}

#endif
