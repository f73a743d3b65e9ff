// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PolyhedralSweep.h
 * @brief Reads contour sets of all formats and runs them through the whole polyhedral method.
 *
 * The files of CONTOUR_SHARED_DATA are other people's and may be absent: then tests skip and say
 * so.
 */
#ifndef recon_Testing_PolyhedralSweep_h
#define recon_Testing_PolyhedralSweep_h

#include "Core/SetsOfData.h"
#include "SurfaceInvariants.h"
#include "TestPaths.h"

#include <gtest/gtest.h>

#include <cctype>
#include <cstdio>
#include <filesystem>
#include <functional>

namespace recon::testing
{
/// A ROI may have no contours, points only, or one plane: nothing to make a surface of.
inline bool MakesASolid(const LoopSoup& soup, ContourSet& contours)
{
  Monitor monitor;
  if (soup.Chains.empty())
  {
    return false;
  }
  try
  {
    contours = BuildContourSet(soup, {}, monitor);
  }
  catch (const Error& error)
  {
    std::printf("[ NOTE     ] not one usable contour: %s\n", error.what());
    return false;
  }
  return contours.Levels.size() > 1;
}

/// Calls check(contours) for everything in the file that can be a solid; returns how many were.
inline int ForEachSolid(
  const std::string& path, const std::function<void(const ContourSet&)>& check)
{
  int solids = 0;
  for (const auto& named : ReadSoups(path))
  {
    SCOPED_TRACE(named.first);
    ContourSet contours;
    if (MakesASolid(named.second, contours))
    {
      ++solids;
      check(contours);
    }
  }
  return solids;
}

struct Case
{
  const char* File;
  int Solids; ///< how many the file has
};

inline std::ostream& operator<<(std::ostream& out, const Case& c)
{
  return out << c.File;
}

/// GoogleTest wants letters and digits.
inline std::string NameOf(const ::testing::TestParamInfo<Case>& info)
{
  std::string name = info.param.File;
  for (char& c : name)
  {
    c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  }
  return name;
}

/// Every set of parallel planes.
inline const Case AllCases[] = {
  { "rtstruct/cerr_ibsi.dcm", 1 },
  { "rtstruct/rtutils_keyholes.dcm", 4 },
  { "rtstruct/rtutils_single_slice_hole.dcm", 0 },
  { "rtstruct/pydicom_no_preamble_points.dcm", 1 },
  { "rtstruct/template_no_contour_data.dcm", 0 },
  { "rtstruct/phantoms/Sphere_10_0.dcm", 1 },
  { "rtstruct/phantoms/Sphere_20_0.dcm", 1 },
  { "rtstruct/phantoms/Sphere_30_0.dcm", 1 },
  { "rtstruct/phantoms/Cone_10_0.dcm", 1 },
  { "rtstruct/phantoms/Cone_20_0.dcm", 1 },
  { "rtstruct/phantoms/Cone_30_0.dcm", 1 },
  { "rtstruct/phantoms/Cylinder_10_0.dcm", 1 },
  { "rtstruct/phantoms/Cylinder_20_0.dcm", 1 },
  { "rtstruct/phantoms/Cylinder_30_0.dcm", 1 },
  { "rtstruct/phantoms/RtCone_10_0.dcm", 1 },
  { "rtstruct/phantoms/RtCone_20_0.dcm", 1 },
  { "rtstruct/phantoms/RtCone_30_0.dcm", 1 },
  { "rtstruct/phantoms/RtCylinder_10_0.dcm", 1 },
  { "rtstruct/phantoms/RtCylinder_20_0.dcm", 1 },
  { "rtstruct/phantoms/RtCylinder_30_0.dcm", 1 },
  { "cnt/manytomany.cnt", 1 },
  { "cnt/frog_label3.cnt", 1 },
  { "cnt/spl_left_hippocampus.cnt", 1 },
  { "csl/eight_15.csl", 1 },
  { "csl/hand_ok.csl", 1 },
  { "csl/balloondog.csl", 1 },
  { "csl/SideBishop.csl", 1 },
  { "csl/rose.csl", 1 },
  { "rtstruct/dicompyler_rtss.dcm", 9 },
  { "rtstruct/dicomexport_rs.dcm", 11 },
  { "rtstruct/pyorthanc_cone_02mm.dcm", 1 },
  { "cnt/amygdala_label3.cnt", 1 },
  { "cnt/sainthelens_100m.cnt", 1 },
  { "cnt/sainthelens_unequal.cnt", 1 },
};

/// Networks and sections of several directions: the planes of the commonest direction are taken.
inline const Case NetworkCases[] = {
  { "csl/armadillo.csl", 1 },
  { "csl/armadillo_simplified_from_mesh.csl", 1 },
  { "csl/Heart-25-even-better.csl", 1 },
  { "csl/Skull-20.csl", 1 },
  { "csl/Vetebrae.csl", 1 },
  { "contour/ctrmapping.contour", 1 },
  { "contour/eight_15.contour", 1 },
  { "contour/inconsistent_Bermano.contour", 1 },
  { "contour/inconsistent_ferretbrain.contour", 1 },
  { "contour/inconsistent_mousebrain.contour", 3 },
  { "contour/inconsistent_newliver.contour", 1 },
  { "contour/liver.contour", 0 },
  { "contour/mousebrain.contour", 3 },
  { "contour/mug.contour", 1 },
  { "contour/ringc.contour", 0 },
};

class PolyhedralSweep : public ::testing::TestWithParam<Case>
{
protected:
  void SetUp() override
  {
    this->Path = SharedPath(GetParam().File);
    if (!std::filesystem::exists(this->Path))
    {
      GTEST_SKIP() << "no " << this->Path << ": this real contour set was NOT tested";
    }
  }

  std::string Path;
};

/// What the user chooses about joins and ends, every combination that gives a closed surface.
inline void ExpectAllCombinations(const ContourSet& contours)
{
  for (const auto mapping : { PolyhedralOptions::Proximity, PolyhedralOptions::Overlap })
  {
    for (const auto caps : { PolyhedralOptions::Flat, PolyhedralOptions::HalfSlice,
           PolyhedralOptions::Tapered, PolyhedralOptions::Extrapolated })
    {
      for (const auto isolated : { PolyhedralOptions::Drop, PolyhedralOptions::Extrude })
      {
        PolyhedralOptions options;
        options.Mapping = mapping;
        options.EndCaps = caps;
        options.IsolatedContours = isolated;
        SCOPED_TRACE(Describe(options));
        ExpectKeepsPromisesOrIsEmpty(BuildSurface(contours, options), contours);
      }
    }
  }
}

inline void ExpectAllOptions(const ContourSet& contours)
{
  for (const bool internalPoints : { false, true })
  {
    for (const bool lift : { false, true })
    {
      SCOPED_TRACE(std::string(internalPoints ? "with" : "without") + " internal points, " +
        (lift ? "lifted" : "not lifted"));
      PolyhedralOptions options;
      options.InternalPoints = internalPoints;
      options.LiftInternalPoints = lift;
      options.Threads = 1;
      const PolyhedralSurface surface = BuildSurface(contours, options);
      ExpectKeepsPromises(surface, contours);
      options.Threads = 3;
      ExpectEqualSurfaces(surface, BuildSurface(contours, options));
    }
  }
}

}

#endif
