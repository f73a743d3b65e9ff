// SPDX-License-Identifier: GPL-3.0-or-later
#include "CertificateShapes.h"
#include "Mesh/Certificate.h"
#include "Mesh/MeshDefects.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

TEST(Certificate, SoundCube)
{
  const ContourSet contours = MakeSquareLevel(0.5, 0);
  const SurfaceCertificate certificate = CertifyMesh(MakeCube(), &contours);
  EXPECT_TRUE(certificate.Total.IsSound());
  EXPECT_EQ(certificate.Total.Mass.Volume, 1);
  EXPECT_EQ(certificate.WorstSectionPercent(), 0);
  EXPECT_EQ(certificate.TotalSectionPercent(), 0);
  ASSERT_TRUE(certificate.Distance.has_value());
  EXPECT_EQ(certificate.Distance->Vertices, 4);
}

TEST(Certificate, ComponentsAreJudgedApart)
{
  TriangleMesh mesh = MakeBox({ 0, 0, 0 }, { 2, 2, 2 });
  Append(mesh, MakeBox({ 1, 0.5, 0.25 }, { 3, 1.5, 1.125 })); // crosses the first
  Append(mesh, MakeBox({ 5, 5, 5 }, { 6, 6, 6 }));
  TriangleMesh open = MakeBox({ 8, 8, 8 }, { 9, 9, 9 });
  open.Triangles.pop_back();
  Append(mesh, open);
  const SurfaceCertificate certificate = CertifyMesh(mesh);
  ASSERT_EQ(certificate.Components.size(), 4u);
  const auto& parts = certificate.Components;
  EXPECT_GT(certificate.Total.Pairs.Crossing, 0);
  EXPECT_EQ(parts[0].Pairs.Crossing, certificate.Total.Pairs.Crossing);
  EXPECT_EQ(parts[1].Pairs.Crossing, certificate.Total.Pairs.Crossing);
  EXPECT_EQ(parts[2].Pairs.Crossing, 0);
  EXPECT_TRUE(parts[2].IsSound());
  EXPECT_FALSE(parts[0].IsSound());
  EXPECT_FALSE(parts[3].IsSound());
  EXPECT_FALSE(parts[3].Mass.Volume.has_value());
  EXPECT_FALSE(certificate.Total.Mass.Volume.has_value());
  EXPECT_EQ(parts[2].Mass.Volume.value(), 1);
  EXPECT_EQ(certificate.ComponentOfTriangle.back(), 3);
  EXPECT_NE(certificate.DefectOfTriangle.front() | certificate.DefectOfTriangle[11], 0);
  EXPECT_EQ(certificate.DefectOfTriangle[25], 0);
}

TEST(Certificate, WeldedTopologyIsToldApart)
{
  TriangleMesh mesh = MakeBox({ 0, 0, 0 }, { 1, 1, 1 });
  Append(mesh, MakeBox({ 1, 1, 0 }, { 2, 2, 1 }));
  const SurfaceCertificate asIs = CertifyMesh(mesh);
  EXPECT_TRUE(asIs.Total.IsSound());
  EXPECT_GT(asIs.Total.Pairs.Touching, 0);
  EXPECT_EQ(asIs.Welded.OverusedEdges, 1);
  CertificateOptions options;
  options.Weld = true;
  const SurfaceCertificate welded = CertifyMesh(mesh, nullptr, options);
  EXPECT_EQ(welded.Total.Topology.OverusedEdges, 1);
  EXPECT_EQ(welded.Components.size(), 1u);
}

TEST(Certificate, ContoursThatMissAreMeasured)
{
  const ContourSet contours = MakeSquareLevel(0.5, 0.25);
  const SurfaceCertificate certificate = CertifyMesh(MakeCube(), &contours);
  EXPECT_DOUBLE_EQ(certificate.WorstSectionPercent().value(), 50);
  EXPECT_DOUBLE_EQ(certificate.Distance->FarthestVertex, 0.25);
}

TEST(Certificate, OfNothing)
{
  const SurfaceCertificate certificate = CertifyMesh(TriangleMesh());
  EXPECT_FALSE(certificate.Total.IsSound());
  EXPECT_TRUE(certificate.Components.empty());
}

TEST(Certificate, ProgressRisesAndAbortIsHeard)
{
  struct : Monitor
  {
    void OnProgress(double fraction, const char*) override
    {
      EXPECT_GE(fraction, this->Last);
      EXPECT_LE(fraction, 1);
      this->Last = fraction;
    }
    bool AbortRequested() override { return this->Last >= this->StopAt; }
    double Last = 0;
    double StopAt = 2;
  } monitor;
  const ContourSet contours = MakeSquareLevel(0.5, 0);
  Certify(MakeSphere(40, 20), &contours, CertificateOptions(), monitor);
  EXPECT_EQ(monitor.Last, 1);
  for (const double stopAt : { 0.0, 0.5, 0.9 })
  {
    monitor.Last = 0;
    monitor.StopAt = stopAt;
    EXPECT_THROW(Certify(MakeSphere(40, 20), &contours, CertificateOptions(), monitor), Aborted);
  }
}
