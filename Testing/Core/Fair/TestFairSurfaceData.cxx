// SPDX-License-Identifier: GPL-3.0-or-later
/// Sets of others: the fair surface keeps what it promises.
#include "Contours/ContourSetBuilder.h"
#include "Core/Mesh/MeshInvariants.h"
#include "Core/SetsOfData.h"
#include "Fair/FairSurface.h"
#include "Mesh/MeshTopology.h"
#include "Polyhedral/PolyhedralSurface.h"
#include "TestPaths.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

namespace
{
void ExpectPromises(const std::string& name, const LoopSoup& soup)
{
  SCOPED_TRACE(name);
  Monitor monitor;
  ContourSetOptions reading;
  reading.Parallel = true;
  const ContourSet contours = BuildContourSet(soup, reading, monitor);
  FairOptions options;
  options.Polyhedral.Mapping = PolyhedralOptions::Overlap;
  options.Polyhedral.EndCaps = PolyhedralOptions::Tapered;
  options.Polyhedral.PinchGap = 1e-3;
  const FairSurface fair = BuildFairSurface(contours, options, monitor);
  ExpectSoundSurface(fair.Mesh);
  const PolyhedralSurface polyhedral =
    BuildPolyhedralSurface(contours, options.Polyhedral, monitor);
  EXPECT_EQ(CheckTopology(fair.Mesh).Total.Euler, CheckTopology(polyhedral.Mesh).Total.Euler);
  EXPECT_EQ(fair.Beyond, 0u) << fair.Farthest << " beyond " << fair.Tolerance;
}
}

class FairSurfaceData : public SharedData
{
};

TEST_F(FairSurfaceData, KeepsItsPromises)
{
  const std::filesystem::path shared = SharedPath();
  for (const char* file : { "csl/eight_15.csl", "csl/hand_ok.csl" })
  {
    for (const NamedSoup& named : ReadSoups((shared / file).string()))
    {
      ExpectPromises(file + (" " + named.first), named.second);
    }
  }
}
