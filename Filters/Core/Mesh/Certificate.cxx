// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/Certificate.h"

#include "Base/SubMonitor.h"
#include "Mesh/MeshDefects.h"
#include "Mesh/TriangleTree.h"

#include <algorithm>
#include <set>
#include <utility>

namespace recon
{
namespace
{
/// Shares of the time of each stage, for the progress.
struct Shares
{
  double Topology;
  double Intersections;
  double Sections;
};

Shares SharesOf(const ContourSet* contours)
{
  return contours ? Shares{ 0.2, 0.6, 0.8 } : Shares{ 0.25, 1, 1 };
}

void TakeTopology(const MeshTopology& topology, SurfaceCertificate& certificate)
{
  certificate.Total.Topology = topology.Total;
  certificate.Components.resize(topology.Components.size());
  for (std::size_t c = 0; c < topology.Components.size(); ++c)
  {
    certificate.Components[c].Topology = topology.Components[c];
    certificate.Components[c].Nesting = topology.Nesting[c];
    certificate.Total.Nesting = std::max(certificate.Total.Nesting, topology.Nesting[c]);
  }
  certificate.ComponentOfTriangle = topology.ComponentOfTriangle;
  certificate.DefectOfTriangle = topology.DefectOfTriangle;
}

void TakeMass(const TriangleMesh& mesh, SurfaceCertificate& certificate)
{
  std::vector<bool> encloses;
  for (const auto& component : certificate.Components)
  {
    encloses.push_back(component.Topology.EnclosesVolume());
  }
  const auto figures = ComputeMassProperties(mesh, certificate.ComponentOfTriangle, encloses);
  for (std::size_t c = 0; c < certificate.Components.size(); ++c)
  {
    certificate.Components[c].Mass = figures[c];
  }
  certificate.Total.Mass = figures.back();
}

void TakeIntersections(SelfIntersections&& found, SurfaceCertificate& certificate)
{
  certificate.Total.Pairs = found;
  for (std::size_t c = 0; c < found.CountsOfComponent.size(); ++c)
  {
    certificate.Components[c].Pairs = found.CountsOfComponent[c];
  }
  for (std::size_t t = 0; t < found.DefectOfTriangle.size(); ++t)
  {
    certificate.DefectOfTriangle[t] |= found.DefectOfTriangle[t];
  }
  certificate.Pairs = std::move(found.Pairs);
}

void TakeSheetCrossings(const SheetCrossings& found, SurfaceCertificate& certificate)
{
  certificate.Total.CrossingEdges = found.Edges;
  std::set<std::pair<int, int>> counted; // edge and component
  for (const auto& [edge, triangle] : found.Triangles)
  {
    const int component = certificate.ComponentOfTriangle[triangle];
    if (counted.emplace(edge, component).second)
    {
      ++certificate.Components[component].CrossingEdges;
    }
    certificate.DefectOfTriangle[triangle] |= DefectCrossing;
  }
}

SurfaceCertificate CertifyAsIs(const TriangleMesh& mesh, const ContourSet* contours,
  const CertificateOptions& options, Monitor& monitor)
{
  const Shares shares = SharesOf(contours);
  SurfaceCertificate certificate;
  monitor.Update(0, "checking topology");
  TakeTopology(CheckTopology(mesh), certificate);
  monitor.Update(shares.Topology / 2, "checking topology");
  certificate.Welded = CheckTopology(WeldPoints(mesh)).Total;
  TakeMass(mesh, certificate);

  SelfIntersectionOptions pairs;
  pairs.Threads = options.Threads;
  pairs.ComponentOfTriangle = &certificate.ComponentOfTriangle;
  SubMonitor pairsMonitor(monitor, shares.Topology, shares.Intersections);
  TakeIntersections(FindSelfIntersections(mesh, pairs, pairsMonitor), certificate);
  TakeSheetCrossings(FindSheetCrossings(mesh), certificate);
  if (!contours)
  {
    return certificate;
  }
  SubMonitor sectionsMonitor(monitor, shares.Intersections, shares.Sections);
  certificate.Sections = CompareSections(
    mesh, *contours, { options.Threads, options.CoordinateRounding }, sectionsMonitor);
  SubMonitor distanceMonitor(monitor, shares.Sections, 1);
  certificate.Distance =
    MeasureContourDistance(mesh, TriangleTree(mesh), *contours, options.Threads, distanceMonitor);
  return certificate;
}
}

std::optional<double> SurfaceCertificate::WorstSectionPercent() const
{
  std::optional<double> worst;
  for (const auto& section : this->Sections)
  {
    if (!section.Percent)
    {
      return std::nullopt;
    }
    worst = std::max(worst.value_or(0), *section.Percent);
  }
  return worst;
}

std::optional<double> SurfaceCertificate::TotalSectionPercent() const
{
  double difference = 0;
  double area = 0;
  for (const auto& section : this->Sections)
  {
    if (!section.SymmetricDifference)
    {
      return std::nullopt;
    }
    difference += *section.SymmetricDifference;
    area += section.ContourArea;
  }
  return area > 0 ? std::optional<double>(100 * difference / area) : std::nullopt;
}

SurfaceCertificate Certify(const TriangleMesh& mesh, const ContourSet* contours,
  const CertificateOptions& options, Monitor& monitor)
{
  if (options.Weld)
  {
    return CertifyAsIs(WeldPoints(mesh), contours, options, monitor);
  }
  return CertifyAsIs(mesh, contours, options, monitor);
}
}
