// SPDX-License-Identifier: GPL-3.0-or-later
// The whole method in one call: topology, volume, cavities, refined normals, progress, abort,
// refusal.
#include "Core/Mesh/MeshInvariants.h"
#include "Implicit/ImplicitSurface.h"
#include "ImplicitShapes.h"

using namespace recon;
using namespace recon::testing;

namespace
{
ImplicitSurface Build(const ContourSet& contours, const ImplicitSurfaceOptions& options = {})
{
  Monitor monitor;
  return BuildImplicitSurface(contours, options, monitor);
}

double VolumeOf(const TriangleMesh& mesh)
{
  const std::vector<int> one(mesh.Triangles.size(), 0);
  return ComputeSignedVolumes(mesh, one, 1).front();
}

/// Cells large enough for a test that is about topology.
ImplicitSurfaceOptions Coarse()
{
  ImplicitSurfaceOptions options;
  options.Polygonizer.CellSize = 0.7;
  return options;
}

/// A ball with a concentric cavity.
ContourSet Shell()
{
  const ContourSet outer = handmade::SphereSlices({ 0, 0, 0 }, 10, 11, 40);
  handmade::Maker maker;
  for (std::size_t l = 0; l < outer.Levels.size(); ++l)
  {
    const double z = outer.Levels[l].Offset;
    const int level = maker.AddLevel({ 0, 0, 1 }, z);
    std::vector<Point3> loop;
    for (const int p : outer.Contours[l].Points)
    {
      loop.push_back(outer.Points[static_cast<std::size_t>(p)]);
    }
    maker.AddContour(level, loop);
    if (std::abs(z) < 4.9)
    {
      maker.AddCircle(level, { 0, 0 }, std::sqrt(25 - z * z), 24);
    }
  }
  return maker.Finish();
}

class Recorder : public Monitor
{
public:
  double Last = 0;
  int Calls = 0;
  int AbortAfter = -1;
  bool AbortRequested() override { return this->AbortAfter >= 0 && this->Calls > this->AbortAfter; }

protected:
  void OnProgress(double fraction, const char*) override
  {
    EXPECT_LE(fraction, 1);
    this->Last = fraction;
    ++this->Calls;
  }
};
}

TEST(ImplicitSurface, RefinedNormalsMakeTheSphereTrue)
{
  const ContourSet slices = handmade::SphereSlices({ 0, 0, 0 }, 12, 9, 60);
  const double truth = 4.0 / 3 * handmade::Pi * 12 * 12 * 12;
  ImplicitSurfaceOptions options;
  options.Polygonizer.Box = Bounds{ -15, 15, -15, 15, -15, 15 };
  const ImplicitSurface refined = Build(slices, options);
  options.Constraints.Normals = ConstraintOptions::InPlane;
  const ImplicitSurface inPlane = Build(slices, options);
  options.Constraints.Values = ConstraintOptions::Unit;
  const ImplicitSurface thesis = Build(slices, options);
  ExpectSoundSurface(refined.Mesh.Mesh);
  ExpectSoundSurface(thesis.Mesh.Mesh);
  const double error = std::abs(VolumeOf(refined.Mesh.Mesh) / truth - 1);
  EXPECT_LT(error, 0.005);
  EXPECT_LT(error, std::abs(VolumeOf(inPlane.Mesh.Mesh) / truth - 1));
  EXPECT_LT(error, std::abs(VolumeOf(thesis.Mesh.Mesh) / truth - 1));
}

TEST(ImplicitSurface, TipsDoNotSpoilTheVolume)
{
  // Slices that touch the poles, as phantoms have: in-plane margins there cost 2% to 5%.
  handmade::Maker maker;
  for (const double end : { -12.0, 12.0 })
  {
    maker.AddCircle(maker.AddLevel({ 0, 0, 1 }, end), { 0, 0 }, 0.1, 6);
  }
  for (int i = -3; i <= 3; ++i)
  {
    const double z = 3.0 * i;
    maker.AddCircle(maker.AddLevel({ 0, 0, 1 }, z), { 0, 0 }, std::sqrt(144 - z * z), 60);
  }
  ImplicitSurfaceOptions options;
  options.Polygonizer.Box = Bounds{ -15, 15, -15, 15, -15, 15 };
  const double truth = 4.0 / 3 * handmade::Pi * 12 * 12 * 12;
  const ImplicitSurface ball = Build(maker.Finish(), options);
  ExpectSoundSurface(ball.Mesh.Mesh);
  EXPECT_LT(std::abs(VolumeOf(ball.Mesh.Mesh) / truth - 1), 0.002);
  options.Constraints.Normals = ConstraintOptions::InPlane;
  EXPECT_GT(std::abs(VolumeOf(Build(maker.Finish(), options).Mesh.Mesh) / truth - 1), 0.004);
}

TEST(ImplicitSurface, TorusHasAHandle)
{
  const ImplicitSurface torus = Build(handmade::TorusSlices(10, 4, 15, 24), Coarse());
  ExpectSoundSurface(torus.Mesh.Mesh);
  EXPECT_EQ(CheckTopology(torus.Mesh.Mesh).Total.Euler, 0);
  EXPECT_GE(torus.Mesh.SmallestAngle, 1);
  EXPECT_NEAR(VolumeOf(torus.Mesh.Mesh), 2 * handmade::Pi * handmade::Pi * 10 * 16, 60);
}

TEST(ImplicitSurface, PreviewsAreSoundAndSaySo)
{
  // Many slices and points: what a preview is for.
  const ContourSet torus = handmade::TorusSlices(10, 4, 60, 200);
  const double truth = 2 * handmade::Pi * handmade::Pi * 10 * 16;
  std::size_t fewer = 0;
  for (const auto detail : { PolygonizerOptions::Coarse, PolygonizerOptions::Medium })
  {
    ImplicitSurfaceOptions options;
    options.Polygonizer.Detail = detail;
    options.Polygonizer.CellSize = 0.01; // finer than a preview's cells, so without effect
    const ImplicitSurface preview = Build(torus, options);
    ExpectSoundSurface(preview.Mesh.Mesh);
    EXPECT_EQ(CheckTopology(preview.Mesh.Mesh).Total.Euler, 0);
    EXPECT_NEAR(VolumeOf(preview.Mesh.Mesh), truth, 0.05 * truth);
    EXPECT_NE(preview.Report.back().find("preview"), std::string::npos) << preview.Report.back();
    EXPECT_GT(preview.Fit.Function.Centres.size(), fewer);
    fewer = preview.Fit.Function.Centres.size();
    EXPECT_LT(fewer, detail == PolygonizerOptions::Coarse ? 2500u : 7000u);
    EXPECT_TRUE(detail == PolygonizerOptions::Coarse || preview.Mesh.SmallestAngle >= 1);
    options.Polygonizer.CellSize = 3; // coarser, so it counts
    EXPECT_EQ(Build(torus, options).Mesh.CellSize, 3);
  }
}

TEST(ImplicitSurface, CavitiesAreTurnedInward)
{
  // Thesis 12.2: the wall of a hole has its inner constraints outside the hole.
  const ImplicitSurface shell = Build(Shell(), Coarse());
  ExpectSoundSurface(shell.Mesh.Mesh);
  EXPECT_EQ(CheckTopology(shell.Mesh.Mesh).Total.Components, 2);
  const double truth = 4.0 / 3 * handmade::Pi * (1000 - 125);
  EXPECT_NEAR(VolumeOf(shell.Mesh.Mesh), truth, 0.02 * truth);
}

TEST(ImplicitSurface, FlatEndsAreWhereEndsBeyondSays)
{
  handmade::Maker maker;
  for (int i = 0; i < 5; ++i)
  {
    maker.AddCircle(maker.AddLevel({ 0, 0, 1 }, 2.0 * i), { 0, 0 }, 6, 40);
  }
  const ContourSet column = maker.Finish();
  for (const double beyond : { 0.0, 0.4, 0.5 })
  {
    ImplicitSurfaceOptions options = Coarse();
    options.EndsBeyond = beyond;
    const TriangleMesh mesh = Build(column, options).Mesh.Mesh;
    ExpectSoundSurface(mesh);
    const Bounds box = BoundsOf(mesh.Points);
    EXPECT_EQ(box[4], 0 - 2 * beyond);
    EXPECT_EQ(box[5], 8 + 2 * beyond);
    const double truth = handmade::Pi * 36 * (8 + 4 * beyond);
    EXPECT_NEAR(VolumeOf(mesh), truth, 0.01 * truth);
  }
}

TEST(ImplicitSurface, PlanesOfThreeDirections)
{
  handmade::Maker maker;
  maker.AddCircle(maker.AddLevel({ 0, 0, 1 }, 0), { 0, 0 }, 10, 24);
  maker.AddCircle(maker.AddLevel({ 1, 0, 0 }, 0), { 0, 0 }, 10, 24);
  maker.AddCircle(maker.AddLevel({ 0, 1, 0 }, 0), { 0, 0 }, 10, 24);
  for (const double merge : { 0.0, 0.05 })
  {
    ImplicitSurfaceOptions options = Coarse();
    options.Constraints.MergeBox = merge;
    const ImplicitSurface ball = Build(maker.Finish(), options);
    ExpectSoundSurface(ball.Mesh.Mesh);
    EXPECT_EQ(CheckTopology(ball.Mesh.Mesh).Total.Euler, 2);
    const double truth = 4.0 / 3 * handmade::Pi * 1000;
    EXPECT_NEAR(VolumeOf(ball.Mesh.Mesh), truth, 0.03 * truth);
  }
}

TEST(ImplicitSurface, CornersModeAndWendland)
{
  const ContourSet slices = handmade::SphereSlices({ 0, 0, 0 }, 10, 9, 36);
  ImplicitSurfaceOptions options = Coarse();
  options.Constraints.Mode = ConstraintOptions::BoundingBoxCorners;
  ExpectSoundSurface(Build(slices, options).Mesh.Mesh);
  options = Coarse();
  options.Function.Kind = Kernel::Wendland;
  options.Function.SupportRadius = 12;
  const ImplicitSurface compact = Build(slices, options);
  ExpectClosed(compact.Mesh.Mesh);
  ExpectManifold(compact.Mesh.Mesh);
  EXPECT_LT(compact.Fit.Function.Residual, 1e-6);
}

TEST(ImplicitSurface, ProgressAndAbort)
{
  const ContourSet slices = handmade::SphereSlices({ 0, 0, 0 }, 10, 9, 36);
  Recorder recorder;
  BuildImplicitSurface(slices, Coarse(), recorder);
  EXPECT_EQ(recorder.Last, 1);
  EXPECT_GT(recorder.Calls, 30);
  for (const int after : { 0, recorder.Calls / 3, recorder.Calls * 2 / 3 })
  {
    Recorder stopper;
    stopper.AbortAfter = after;
    EXPECT_THROW(BuildImplicitSurface(slices, Coarse(), stopper), Aborted);
  }
}

TEST(ImplicitSurfaceInvalid, EachBadInputHasItsSentence)
{
  handmade::Maker maker;
  maker.AddCircle(maker.AddLevel({ 0, 0, 1 }, 0), { 0, 0 }, 10, 36);
  EXPECT_THROW(Build(maker.Finish()), Error);
  EXPECT_THROW(Build(ContourSet()), Error);
  const ContourSet good = handmade::SphereSlices({ 0, 0, 0 }, 10, 5, 16);
  ImplicitSurfaceOptions options;
  options.Polygonizer.CellSize = 1e-6;
  EXPECT_THROW(Build(good, options), Error);
  options.Polygonizer.CellSize = -1;
  EXPECT_THROW(Build(good, options), Error);
  options = ImplicitSurfaceOptions();
  options.Polygonizer.Box = Bounds{ 1, -1, 0, 1, 0, 1 };
  EXPECT_THROW(Build(good, options), Error);
  options = ImplicitSurfaceOptions();
  options.EndsBeyond = -0.1;
  EXPECT_THROW(Build(good, options), Error);
}
