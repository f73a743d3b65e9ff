// SPDX-License-Identifier: GPL-3.0-or-later
// Real sets turned out of the axes, as they are and stored with three decimals, so that points lie beside their
// planes: no surface crosses itself in the coordinates that are given out.
#include "DegenerateStacks.h"
#include "NodeDefaults.h"
#include "PolyhedralSweep.h"

using namespace recon;
using namespace recon::testing;

namespace
{
void ExpectSoundTilted(const LoopSoup& soup, unsigned seed, double unit)
{
  SoupMaker maker;
  maker.Soup = soup;
  maker = Tilted(maker, seed);
  for (Point3& p : maker.Soup.Points)
  {
    for (double& x : p)
    {
      x = unit > 0 ? std::round(x / unit) * unit : x;
    }
  }
  ContourSet contours;
  if (!MakesASolid(maker.Soup, contours))
  {
    return;
  }
  const PolyhedralSurface surface = BuildSurface(contours, NodeOptions());
  ExpectSoundSurface(surface.Mesh);
  const LeftOut leftOut = ContoursLeftOut(surface);
  ExpectContourVertices(surface, WithoutContours(contours, leftOut.Wholly));
}
}

using TiltedSets = PolyhedralSweep;

TEST_P(TiltedSets, DoNotCrossThemselves)
{
  for (const auto& named : ReadSoups(this->Path))
  {
    for (const double unit : { 0.0, 0.001 })
    {
      SCOPED_TRACE(named.first + ", coordinates in steps of " + std::to_string(unit));
      ExpectSoundTilted(named.second, 1, unit);
      ExpectSoundTilted(named.second, 2, unit);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, TiltedSets, ::testing::ValuesIn(AllCases), NameOf);
