// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ConstrainedDelaunay.h
 * @brief CGAL's constrained Delaunay triangulation as the levels use it.
 *
 * For source files only: other headers keep CGAL out.
 */
#ifndef recon_ConstrainedDelaunay_h
#define recon_ConstrainedDelaunay_h

#include "Polyhedral/LevelTriangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <array>
#include <cstddef>

namespace recon::delaunay
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Points that the refinement makes lie on contour edges, so that is what a new vertex is.
struct VertexInfo
{
  int Source = -1;
  int Index = -1;
  unsigned char Kind = LevelTriangulation::AddedOnContour;
  unsigned char AskedBy = 0;
};

struct FaceInfo
{
  int Index = -1;
  bool Inside = false;
  std::array<int, 3> EdgeContour{ { -1, -1, -1 } };
};

/// Handles compare by age and not by address: CGAL refines edges in an order that follows from
/// comparing handles, so the result would differ from run to run and between numbers of threads.
template <typename Base>
class Stamped : public Base
{
public:
  using Has_timestamp = CGAL::Tag_true;
  template <typename Structure>
  struct Rebind_TDS
  {
    using Other = Stamped<typename Base::template Rebind_TDS<Structure>::Other>;
  };

  using Base::Base;

  std::size_t time_stamp() const { return this->Stamp; }
  void set_time_stamp(const std::size_t& stamp) { this->Stamp = stamp; }

private:
  std::size_t Stamp = static_cast<std::size_t>(-1); // CGAL's word for "none yet"
};

using VertexBase = Stamped<CGAL::Triangulation_vertex_base_with_info_2<VertexInfo, Kernel>>;
using FaceBase0 = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using FaceBase = Stamped<CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel, FaceBase0>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;
using VertexHandle = Triangulation::Vertex_handle;
using FaceHandle = Triangulation::Face_handle;
using Edge = Triangulation::Edge;
}

#endif
