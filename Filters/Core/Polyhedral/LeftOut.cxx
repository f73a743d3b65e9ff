// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/LeftOut.h"

#include "Base/PointHash.h"
#include "Base/Text.h"
#include "Polyhedral/DelaunayEdges.h"
#include "Polyhedral/NeedleContours.h"

#include <algorithm>
#include <sstream>
#include <unordered_set>

namespace recon
{
namespace
{
bool IsMade(const LevelState& lower, const LevelState& upper, const SlabTetrahedra& slab, int wall1,
  int wall2)
{
  return slab.GapRegions.count({ wall1, wall2 }) > 0 ||
    std::any_of(slab.Tetrahedra.begin(), slab.Tetrahedra.end(),
      [&](const auto& t)
      {
        return t.Reason == SlabTetrahedra::Kept && t.Node == SlabTetrahedra::T12 &&
          RegionAtEdge(lower.Triangulation, t.Origin[0]) == wall1 &&
          RegionAtEdge(upper.Triangulation, t.Origin[1]) == wall2;
      });
}

/// What a contour bounds, as bits: one that touches another or is touched by its holes may bound
/// several regions, some of which are kept.
constexpr unsigned char Kept = 1;
constexpr unsigned char Isolated = 2;

std::string LeftOutLine(
  const ContourSet& contours, std::size_t c, bool inPart, const PolyhedralOptions& options)
{
  const Contour& contour = contours.Contours[c];
  std::ostringstream line;
  line << "Contour " << c << " (level " << contour.Level << ", offset "
       << contours.Levels[contour.Level].Offset << ", " << contour.Points.size()
       << " points): left out"
       << (inPart ? " in part, as it bounds several regions that only touch and one of them is "
                    "joined to no contour of the levels next to it"
                  : ", as it is joined to no contour of the levels next to it")
       << "; set IsolatedContours to Extrude to keep it as a slice"
       << (options.Mapping == PolyhedralOptions::Overlap
              ? ", or Mapping to Proximity to join it to what is near."
              : ".");
  return line.str();
}

std::string NotMadeLine(int lower, int upper)
{
  std::ostringstream line;
  line << "The join of contours " << lower << " and " << upper
       << " was asked for but cannot be made: other contours lie between them, or no part of the "
          "one lies over the other; a slice between their two would join them.";
  return line.str();
}

/// Pieces that nobody asked for are counted.
void ReportExtruded(const ContourSet& contours, const std::vector<unsigned char>& bounds,
  std::vector<std::string>& report)
{
  std::vector<std::string> places;
  for (std::size_t c = 0; c < bounds.size(); ++c)
  {
    if ((bounds[c] & Isolated) != 0 && contours.Contours[c].Depth % 2 == 0)
    {
      places.push_back(std::to_string(c) + " (offset " +
        Text(contours.Levels[contours.Contours[c].Level].Offset) + ")");
    }
  }
  if (!places.empty())
  {
    const bool one = places.size() == 1;
    report.push_back(Counted(places.size(), "contour") + (one ? " is" : " are") +
      " joined to none of the levels next to " + (one ? "it" : "them") + " and " +
      (one ? "is a slice of its" : "are slices of their") +
      " own (IsolatedContours is Extrude): " + Listed(places, 3) + ".");
  }
}
}

StageReport::StageReport(
  const ContourSet& contours, const PolyhedralOptions& options, const ContourMapping& mapping)
  : Contours(contours),
    Options(options),
    Bounds(contours.Contours.size(), 0)
{
  for (const ContourJoin& join : mapping.Joins)
  {
    if (join.Rule == ContourJoin::Forced && join.LowerRegion >= 0 && join.UpperRegion >= 0)
    {
      this->Forced.push_back({ join.Slab, mapping.Regions[join.LowerRegion].Wall,
        mapping.Regions[join.UpperRegion].Wall, false });
    }
  }
}

void StageReport::AddLevel(const LevelState& level)
{
  for (const int contour : level.Needles)
  {
    this->Needles.push_back(DescribeNeedle(this->Contours, contour));
  }
  const LevelTriangulation& triangulation = level.Triangulation;
  if (!triangulation.IsGabriel)
  {
    this->WithoutCondition2.push_back(Text(level.Offset));
  }
  for (std::size_t t = 0; t < triangulation.Triangles.size(); ++t)
  {
    for (const int contour : triangulation.EdgeContour[t])
    {
      if (contour >= 0 && triangulation.Inside[t])
      {
        this->Bounds[contour] |= level.Covered.Isolated[t] ? Isolated : Kept;
      }
    }
  }
}

void StageReport::AddSlab(
  int slab, const LevelState& lower, const LevelState& upper, const SlabTetrahedra& diagram)
{
  for (ForcedJoin& join : this->Forced)
  {
    if (join.Slab == slab)
    {
      join.Made = IsMade(lower, upper, diagram, join.Lower, join.Upper);
    }
  }
}

void StageReport::Write(std::vector<std::string>& report) const
{
  report.insert(report.end(), this->Needles.begin(), this->Needles.end());
  if (!this->WithoutCondition2.empty())
  {
    report.push_back("On " + Counted(this->WithoutCondition2.size(), "level") + " (at offset " +
      Listed(this->WithoutCondition2, 3) +
      ") contours run so near to each other, or to themselves, that their edges have fewer points "
      "than the method asks for: the surface is whole there, but may be joined less smoothly.");
  }
  for (const ForcedJoin& join : this->Forced)
  {
    if (!join.Made)
    {
      report.push_back(NotMadeLine(join.Lower, join.Upper));
    }
  }
  if (this->Options.IsolatedContours == PolyhedralOptions::Extrude)
  {
    ReportExtruded(this->Contours, this->Bounds, report);
    return;
  }
  for (std::size_t c = 0; c < this->Bounds.size(); ++c)
  {
    if (this->Bounds[c] & Isolated)
    {
      report.push_back(
        LeftOutLine(this->Contours, c, (this->Bounds[c] & Kept) != 0, this->Options));
    }
  }
}

std::size_t CountLeftOut(const ContourSet& contours, const TriangleMesh& mesh)
{
  const std::unordered_set<Point3, PointHash> points(
    mesh.Points.begin(), mesh.Points.end(), 2 * mesh.Points.size());
  const auto isInSurface = [&](int p) { return points.count(contours.Points[p]) > 0; };
  return std::count_if(contours.Contours.begin(), contours.Contours.end(),
    [&](const Contour& c) { return std::none_of(c.Points.begin(), c.Points.end(), isInSurface); });
}

void CheckNotEmpty(const TriangleMesh& mesh, const std::vector<std::string>& report)
{
  if (mesh.Triangles.empty())
  {
    throw Error(
      "No surface came out: " + (report.empty() ? "no contour has a partner." : report.back()));
  }
}
}
