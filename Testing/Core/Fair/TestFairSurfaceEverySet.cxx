// SPDX-License-Identifier: GPL-3.0-or-later
/// Every set of parallel contours that there is: the fair surface keeps what it promises.
#include "Contours/ContourSetBuilder.h"
#include "Core/SetsOfData.h"
#include "FairPromises.h"

using namespace recon;
using namespace recon::testing;

class FairSurfaceEverySet : public SharedData
{
protected:
  static void Expect(const char* folder, const char* extension)
  {
    int seen = 0;
    ForSoups(SharedPath(folder), extension,
      [&](const std::string& name, const LoopSoup& soup)
      {
        SCOPED_TRACE(name);
        Monitor monitor;
        ContourSetOptions reading;
        reading.Parallel = true;
        try
        {
          ExpectPromises(BuildContourSet(soup, reading, monitor), NodeFairOptions());
          ++seen;
        }
        catch (const Error& error)
        {
          // Contours that make no surface, with the reason.
          std::printf("%s: %s\n", name.c_str(), error.what());
        }
      });
    EXPECT_GT(seen, 0);
  }
};

TEST_F(FairSurfaceEverySet, OfNetworks)
{
  Expect("csl", ".csl");
  Expect("contour", ".contour");
}

TEST_F(FairSurfaceEverySet, OfSlices)
{
  Expect("cnt", ".cnt");
}

TEST_F(FairSurfaceEverySet, OfACohort)
{
  Expect("ibsi", ".dcm");
}

TEST_F(FairSurfaceEverySet, OfStructureSets)
{
  Expect("rtstruct", ".dcm");
  Expect("rtstruct/phantoms", ".dcm");
}
