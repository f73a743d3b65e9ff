// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SameSurface.h
 * @brief Two polyhedral surfaces that are to be the same, whatever made them.
 */
#ifndef recon_Testing_SameSurface_h
#define recon_Testing_SameSurface_h

#include "Polyhedral/PolyhedralSurface.h"

#include <gtest/gtest.h>

namespace recon::testing
{
/// To the last bit; only seconds may differ.
inline void ExpectSameSurface(const PolyhedralSurface& made, const PolyhedralSurface& known)
{
  EXPECT_EQ(made.Mesh.Points, known.Mesh.Points);
  EXPECT_EQ(made.Mesh.Triangles, known.Mesh.Triangles);
  EXPECT_EQ(made.Slab, known.Slab);
  EXPECT_EQ(made.FaceKind, known.FaceKind);
  EXPECT_EQ(made.MappingGroup, known.MappingGroup);
  EXPECT_EQ(made.Piece, known.Piece);
  EXPECT_EQ(made.PointKind, known.PointKind);
  EXPECT_EQ(made.EndCapVolume, known.EndCapVolume);
  EXPECT_EQ(made.IsolatedVolume, known.IsolatedVolume);
  EXPECT_EQ(made.Report, known.Report);
}
}

#endif
