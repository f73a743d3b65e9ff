// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces and handles that are asked for, of contours of others.
#include "Core/SetsOfData.h"
#include "Mesh/PiecesAndHandles.h"
#include "NodeDefaults.h"
#include "PolyhedralShapes.h"
#include "SurfaceInvariants.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

using namespace recon;
using namespace recon::testing;

namespace
{
void ExpectMet(const std::string& file, int pieces, int handles)
{
  const std::string path = SharedPath(file);
  if (!std::filesystem::exists(path))
  {
    GTEST_SKIP() << path << " is not there";
  }
  Monitor monitor;
  const ContourSet contours = BuildContourSet(ReadSoups(path)[0].second, {}, monitor);
  PolyhedralOptions options = NodeOptions();
  options.ExpectedPieces = pieces;
  options.ExpectedHandles = handles;
  const PolyhedralSurface surface = BuildSurface(contours, options);
  const PiecesAndHandles count = CountPiecesAndHandles(surface.Mesh);
  EXPECT_EQ(count.Pieces, pieces) << surface.Report.back();
  EXPECT_EQ(count.Handles, handles) << surface.Report.back();
  ExpectKeepsPromises(surface, contours);
}
}

TEST(TopologyContractData, AnEightWithoutItsHandles)
{
  ExpectMet("csl/eight_15.csl", 1, 2);
  ExpectMet("csl/eight_15.csl", 1, 1);
  ExpectMet("csl/eight_15.csl", 1, 0);
}

TEST(TopologyContractData, AHandInTwoPieces)
{
  ExpectMet("csl/hand_ok.csl", 2, 0);
}
