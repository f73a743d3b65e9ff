// SPDX-License-Identifier: GPL-3.0-or-later
/// Sets of others: the fair surface keeps what it promises.
#include "Contours/ContourSetBuilder.h"
#include "Core/SetsOfData.h"
#include "FairPromises.h"

using namespace recon;
using namespace recon::testing;

class FairSurfaceData : public SharedData
{
protected:
  /// Of a file all sets, or those of a name.
  static void Expect(const char* file, const std::string& wanted, double tolerance)
  {
    for (const NamedSoup& named : ReadSoups(SharedPath(file)))
    {
      if (named.first.find(wanted) != std::string::npos && !named.second.Chains.empty())
      {
        SCOPED_TRACE(file + (" " + named.first));
        Monitor monitor;
        ContourSetOptions reading;
        reading.Parallel = true;
        FairOptions options = NodeFairOptions();
        options.Tolerance = tolerance;
        ExpectPromises(BuildContourSet(named.second, reading, monitor), options);
      }
    }
  }
};

TEST_F(FairSurfaceData, KeepsItsPromises)
{
  Expect("csl/eight_15.csl", "", -1);
  Expect("csl/hand_ok.csl", "", -1);
  Expect("csl/balloondog.csl", "", -1);
}

TEST_F(FairSurfaceData, HasNoThinTrianglesWherePointsAreHeldBack)
{
  // Fingers side by side: 28 of them had an angle below 5 degrees.
  const NamedSoup hand = ReadSoups(SharedPath("csl/hand_ok.csl")).front();
  Monitor monitor;
  ContourSetOptions reading;
  reading.Parallel = true;
  const ContourSet contours = BuildContourSet(hand.second, reading, monitor);
  EXPECT_EQ(BuildFairSurface(contours, NodeFairOptions(), monitor).Thin, 0u);
}

TEST_F(FairSurfaceData, KeepsThemWhereContoursFollowPixels)
{
  Expect("cnt/manytomany.cnt", "", -1);
  Expect("ibsi/STS_001_PET.dcm", "", -1);
}

TEST_F(FairSurfaceData, KeepsThemOnAPatient)
{
  Expect("rtstruct/dicompyler_rtss.dcm", "Heart", -1);
  Expect("rtstruct/dicompyler_rtss.dcm", "Lt Lung", -1);
}

TEST_F(FairSurfaceData, GoesThroughEveryVertexWhereThatIsAskedFor)
{
  Expect("csl/eight_15.csl", "", 0);
  Expect("rtstruct/dicompyler_rtss.dcm", "Heart", 0.01);
}
