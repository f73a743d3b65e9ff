// SPDX-License-Identifier: GPL-3.0-or-later
// Every contour set at hand through the whole method: rows 2 to 4 of what the project must show.
#include "PolyhedralShapes.h"
#include "PolyhedralSweep.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace recon;
using namespace recon::testing;

namespace
{
class PolyhedralOptionsSweep : public PolyhedralSweep
{
};

class PolyhedralCombinations : public PolyhedralSweep
{
};

/// TestPolyhedralCombinationsSlow has all.
const Case FewCases[] = {
  { "rtstruct/rtutils_keyholes.dcm", 4 },
  { "rtstruct/phantoms/RtCone_30_0.dcm", 1 },
  { "cnt/manytomany.cnt", 1 },
  { "csl/eight_15.csl", 1 },
  { "csl/hand_ok.csl", 1 },
  { "contour/mousebrain.contour", 3 },
};

/// Small enough to try all options; TestPolyhedralSweepSlow has the others.
const Case OptionCases[] = {
  { "rtstruct/rtutils_keyholes.dcm", 4 },
  { "rtstruct/rtutils_single_slice_hole.dcm", 0 },
  { "rtstruct/pydicom_no_preamble_points.dcm", 1 },
  { "rtstruct/template_no_contour_data.dcm", 0 },
  { "rtstruct/phantoms/Sphere_30_0.dcm", 1 },
  { "rtstruct/phantoms/Cone_30_0.dcm", 1 },
  { "rtstruct/phantoms/Cylinder_30_0.dcm", 1 },
  { "rtstruct/phantoms/RtCone_30_0.dcm", 1 },
  { "rtstruct/phantoms/RtCylinder_30_0.dcm", 1 },
  { "cnt/manytomany.cnt", 1 },
  { "cnt/frog_label3.cnt", 1 },
  { "cnt/spl_left_hippocampus.cnt", 1 },
  { "csl/eight_15.csl", 1 },
  { "csl/hand_ok.csl", 1 },
  { "csl/balloondog.csl", 1 },
  { "csl/SideBishop.csl", 1 },
  { "csl/rose.csl", 1 },
};
}

TEST_P(PolyhedralSweep, KeepsPromises)
{
  const int solids = ForEachSolid(this->Path,
    [](const ContourSet& contours) { ExpectKeepsPromises(BuildSurface(contours), contours); });
  EXPECT_EQ(solids, GetParam().Solids);
}

TEST_P(PolyhedralOptionsSweep, HoldsForEveryOption)
{
  EXPECT_EQ(ForEachSolid(this->Path, ExpectAllOptions), GetParam().Solids);
}

TEST_P(PolyhedralCombinations, KeepPromises)
{
  EXPECT_EQ(ForEachSolid(this->Path, ExpectAllCombinations), GetParam().Solids);
}

INSTANTIATE_TEST_SUITE_P(Data, PolyhedralCombinations, ::testing::ValuesIn(FewCases), NameOf);
INSTANTIATE_TEST_SUITE_P(Data, PolyhedralSweep, ::testing::ValuesIn(AllCases), NameOf);
INSTANTIATE_TEST_SUITE_P(Data, PolyhedralOptionsSweep, ::testing::ValuesIn(OptionCases), NameOf);

/// The project's own sets are always there.
TEST(PolyhedralOwnData, KeepsPromises)
{
  for (const char* name : { "branching_pipe.cnt", "brain.cnt", "head.cnt", "femur_head.csl" })
  {
    SCOPED_TRACE(name);
    EXPECT_EQ(
      ForEachSolid(OwnPath(std::string("Data/") + name),
        [](const ContourSet& contours) { ExpectKeepsPromises(BuildSurface(contours), contours); }),
      1);
  }
}

TEST(PolyhedralOwnData, HoldsForEveryOption)
{
  for (const char* name : { "branching_pipe.cnt", "brain.cnt" })
  {
    SCOPED_TRACE(name);
    EXPECT_EQ(ForEachSolid(OwnPath(std::string("Data/") + name), ExpectAllOptions), 1);
  }
}

namespace
{
/// Frusta between the slices: exact where all slices are similar and in the same position.
double SumOfFrusta(const ContourSet& contours)
{
  std::vector<double> areas(contours.Levels.size(), 0);
  for (const auto& contour : contours.Contours)
  {
    areas[contour.Level] += contour.SignedArea;
  }
  double volume = 0;
  for (std::size_t l = 0; l + 1 < areas.size(); ++l)
  {
    const double height = contours.Levels[l + 1].Offset - contours.Levels[l].Offset;
    volume += height / 3 * (areas[l] + areas[l + 1] + std::sqrt(areas[l] * areas[l + 1]));
  }
  return volume;
}

/// @param truth the volume of the round body, mm3, and how near to it the slices must come
void ExpectPhantomVolume(const std::string& name, double truth, double nearness)
{
  SCOPED_TRACE(name);
  const std::string path = SharedPath("rtstruct/phantoms/" + name);
  if (!std::filesystem::exists(path))
  {
    GTEST_SKIP() << "no " << path << ": this real contour set was NOT tested";
  }
  for (const bool internalPoints : { false, true })
  {
    ForEachSolid(path,
      [&](const ContourSet& contours)
      {
        PolyhedralOptions options;
        options.InternalPoints = internalPoints;
        const double volume = VolumeOf(BuildSurface(contours, options).Mesh);
        const double frusta = SumOfFrusta(contours);
        std::printf("[ FIGURE   ] %s: volume %.2f, frusta %.2f, truth %.2f mm3\n", name.c_str(),
          volume, frusta, truth);
        EXPECT_NEAR(volume, frusta, 1e-3 * frusta);
        EXPECT_NEAR(volume, truth, nearness * truth);
      });
  }
}
}

namespace
{
/// Flat: the slabs. HalfSlice: as planning systems count, half a slab more at both ends.
void ExpectCappedVolume(const ContourSet& contours)
{
  const double area = contours.Contours[0].SignedArea;
  const auto slices = static_cast<double>(contours.Levels.size());
  const double spacing = (contours.Levels.back().Offset - contours.Levels[0].Offset) / (slices - 1);
  for (const auto mapping : { PolyhedralOptions::Proximity, PolyhedralOptions::Overlap })
  {
    PolyhedralOptions options;
    options.Mapping = mapping;
    options.EndCaps = PolyhedralOptions::Flat;
    const double flat = VolumeOf(BuildSurface(contours, options).Mesh);
    options.EndCaps = PolyhedralOptions::HalfSlice;
    const PolyhedralSurface surface = BuildSurface(contours, options);
    const double half = VolumeOf(surface.Mesh);
    std::printf("[ FIGURE   ] %g slices %g apart, area %.4f: Flat %+.5f %%, HalfSlice %+.5f %%\n",
      slices, spacing, area, 100 * (flat / (area * (slices - 1) * spacing) - 1),
      100 * (half / (area * slices * spacing) - 1));
    EXPECT_NEAR(flat, area * (slices - 1) * spacing, 5e-4 * area * (slices - 1) * spacing);
    EXPECT_NEAR(half, area * slices * spacing, 5e-4 * area * slices * spacing);
    EXPECT_NEAR(surface.EndCapVolume, area * spacing, 5e-4 * area * spacing);
  }
}
}

TEST(PolyhedralPhantoms, CylindersWithCaps)
{
  for (const char* spacing : { "10", "20", "30" })
  {
    const std::string path =
      SharedPath(std::string("rtstruct/phantoms/Cylinder_") + spacing + "_0.dcm");
    if (!std::filesystem::exists(path))
    {
      GTEST_SKIP() << "no " << path << ": this real contour set was NOT tested";
    }
    SCOPED_TRACE(path);
    EXPECT_EQ(ForEachSolid(path, ExpectCappedVolume), 1);
  }
}

TEST(PolyhedralPhantoms, CylinderOfOurOwnWithCaps)
{
  ExpectCappedVolume(BuildStack(RingStack(9, { RegularPolygon(240, 12) }), 3));
}

TEST(PolyhedralPhantoms, TheTipsOfAConeAcrossTheSlicesAreKeptByOverlap)
{
  for (const char* spacing : { "10", "20", "30" })
  {
    const std::string path =
      SharedPath(std::string("rtstruct/phantoms/RtCone_") + spacing + "_0.dcm");
    if (!std::filesystem::exists(path))
    {
      GTEST_SKIP() << "no " << path << ": this real contour set was NOT tested";
    }
    SCOPED_TRACE(path);
    ForEachSolid(path,
      [](const ContourSet& contours)
      {
        PolyhedralOptions options;
        const double near = VolumeOf(BuildSurface(contours, options).Mesh);
        options.Mapping = PolyhedralOptions::Overlap;
        const PolyhedralSurface surface = BuildSurface(contours, options);
        EXPECT_TRUE(ContoursLeftOut(surface).Wholly.empty());
        EXPECT_NEAR(VolumeOf(surface.Mesh), near, 1e-9 * near);
      });
  }
}

TEST(PolyhedralPhantoms, ConesAreTheSumOfFrusta)
{
  for (const char* name : { "Cone_10_0.dcm", "Cone_20_0.dcm", "Cone_30_0.dcm" })
  {
    ExpectPhantomVolume(name, 3619.11, 1e-3);
  }
}

TEST(PolyhedralPhantoms, CylindersAreExact)
{
  for (const char* name : { "Cylinder_10_0.dcm", "Cylinder_20_0.dcm", "Cylinder_30_0.dcm" })
  {
    ExpectPhantomVolume(name, 10857.34, 1e-3);
  }
}

TEST(PolyhedralPhantoms, SpheresAreTheSumOfFrusta)
{
  ExpectPhantomVolume("Sphere_10_0.dcm", 7238.23, 0.007);
  ExpectPhantomVolume("Sphere_20_0.dcm", 7238.23, 0.03);
  ExpectPhantomVolume("Sphere_30_0.dcm", 7238.23, 0.05);
}
