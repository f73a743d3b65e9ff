// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/MeshTopology.h"
#include "Mesh/OutwardPieces.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

#include <utility>

using namespace recon;
using namespace recon::testing;

namespace
{
void Append(TriangleMesh& mesh, const TriangleMesh& other, bool turned)
{
  const int first = static_cast<int>(mesh.Points.size());
  mesh.Points.insert(mesh.Points.end(), other.Points.begin(), other.Points.end());
  for (auto corners : other.Triangles)
  {
    for (int& p : corners)
    {
      p += first;
    }
    if (turned)
    {
      std::swap(corners[1], corners[2]);
    }
    mesh.Triangles.push_back(corners);
  }
}
}

TEST(OutwardPieces, TurnsWhatIsThinAndInsideOut)
{
  TriangleMesh mesh = MakeBox({ 0, 0, 0 }, { 2, 2, 2 });
  const TriangleMesh flake = MakeBox({ 5, 0, 0 }, { 7, 2, 1e-9 });
  Append(mesh, flake, true);
  ASSERT_FALSE(CheckTopology(mesh).Total.Outward);
  EXPECT_EQ(TurnThinPiecesOutward(mesh, 1e-8), 1u);
  EXPECT_TRUE(CheckTopology(mesh).Total.Outward);
  TriangleMesh right = MakeBox({ 0, 0, 0 }, { 2, 2, 2 });
  Append(right, flake, false);
  EXPECT_TRUE(mesh.Triangles == right.Triangles);
  EXPECT_EQ(TurnThinPiecesOutward(mesh, 1e-8), 0u) << "there is no more";
}

TEST(OutwardPieces, LeavesCavitiesAndWhatIsThick)
{
  TriangleMesh hollow = MakeBox({ 0, 0, 0 }, { 2, 2, 2 });
  Append(hollow, MakeBox({ 0.5, 0.5, 1 }, { 1.5, 1.5, 1 + 1e-9 }), true);
  const TriangleMesh was = hollow;
  EXPECT_EQ(TurnThinPiecesOutward(hollow, 1e-8), 0u) << "a flat cavity is outward as it is";
  EXPECT_TRUE(hollow.Triangles == was.Triangles);

  TriangleMesh thick;
  Append(thick, MakeBox({ 0, 0, 0 }, { 2, 2, 2 }), true);
  EXPECT_EQ(TurnThinPiecesOutward(thick, 1e-8), 0u) << "which no rounding has done";

  TriangleMesh open = MakeBox({ 0, 0, 0 }, { 2, 2, 1e-9 });
  open.Triangles.pop_back();
  EXPECT_EQ(TurnThinPiecesOutward(open, 1e-8), 0u);
}
