// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourSet.h
 * @brief Clean planar contours, grouped into levels: what both methods start from.
 */
#ifndef recon_ContourSet_h
#define recon_ContourSet_h

#include "Base/BoundingBox.h"
#include "Base/Geometry.h"
#include "Base/Median.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace recon
{
/**
 * Contours as they arrive: any mixture of closed loops, polylines whose last point repeats the
 * first, and loose pieces that must be chained end to end.
 */
struct LoopSoup
{
  struct Chain
  {
    std::vector<int> Points; ///< indices into LoopSoup::Points
    bool Closed = false; ///< an edge joins the last point to the first (which need not be repeated)
    int Source = -1;     ///< number of the input cell, for the report
    int Level = -1;      ///< index into LoopSoup::Levels where an earlier filter found its level
    bool ExclusiveOr = false; ///< defined by even-odd whatever the rule (DICOM CLOSEDPLANAR_XOR)
  };
  /// A level that an earlier filter has found.
  struct KnownLevel
  {
    Vector3 Normal{ 0, 0, 1 };
    double Offset = 0;
    double Thickness = 0; ///< see Level::Thickness
  };
  std::vector<Point3> Points;
  std::vector<Chain> Chains;
  std::vector<KnownLevel> Levels;
  bool Millimetres = false; ///< the unit is known to be the millimetre, as in DICOM

  /// A chain of points of its own, with its number as Source.
  void Append(const std::vector<Point3>& points, bool closed = true)
  {
    Chain chain;
    chain.Closed = closed;
    chain.Source = static_cast<int>(this->Chains.size());
    for (const Point3& p : points)
    {
      chain.Points.push_back(static_cast<int>(this->Points.size()));
      this->Points.push_back(p);
    }
    this->Chains.push_back(std::move(chain));
  }
};

/**
 * One simple closed polygon of a level.
 *
 * Thesis 3.1: walls at even depth are outer walls, counterclockwise about the level's normal and of
 * positive area; those at odd depth are walls of holes, clockwise and of negative area.
 */
struct Contour
{
  std::vector<int> Points; ///< indices into ContourSet::Points, first not repeated, at least 3
  int Level = -1;
  int Depth = 0;         ///< level in the tree of nesting; even = outer wall
  int Parent = -1;       ///< the contour around this one, or -1
  double SignedArea = 0; ///< square units
  int Source = -1; ///< number of the input cell the contour came from (the first, where merged)
};

/// Which loops of a level are walls of holes; see HoleRule.h.
enum class HoleRule
{
  Automatic, ///< even-odd, which is right for holes drawn in either direction and for keyholes
  EvenOdd,
  Winding,
  Keyhole
};

/// All contours of one plane.
struct Level
{
  PlanarFrame Frame;
  double Offset = 0;    ///< along Frame.Normal
  double Thickness = 0; ///< farthest distance of a point from the plane, in the input's units
  /// In-plane coordinates are whole multiples of it; 0: they are those of the input, as they are.
  double Grid = 0;
  std::vector<int> Contours; ///< indices into ContourSet::Contours
  std::string HoleNote;      ///< a sentence: the rule that made the holes, and how they were drawn
};

/**
 * Contours that are simple, do not cross or overlap one another, and are grouped into levels.
 *
 * Guaranteed: every contour has at least three points and a non-zero area; two contours of a level
 * meet in single vertices at most, which they then share by index; no two points of a level have
 * equal planar coordinates; Contours are sorted by level; where the set is Parallel, all levels
 * have one frame and increasing offsets.
 */
struct ContourSet
{
  bool Parallel = false;
  std::vector<Point3>
    Points; ///< exactly as given, to the last bit, but for crossings that had to be computed
  std::vector<Point2> Planar; ///< the same in the frame of their level
  std::vector<Contour> Contours;
  std::vector<Level> Levels;
  std::vector<std::string> Report; ///< a sentence for everything repaired or left out
  /// A sentence where so much was left out that the set is not what was drawn; also in Report. What
  /// shows a result to a user shows this as a warning.
  std::string Warning;

  /// The box around all points of contours.
  Box3 Bounds() const
  {
    Box3 box;
    for (const Contour& contour : this->Contours)
    {
      for (const int p : contour.Points)
      {
        box.Add(this->Points[p]);
      }
    }
    return box;
  }

  /// Median distance of neighbouring levels, 0 where there are none.
  double Spacing() const
  {
    std::vector<double> distances;
    for (std::size_t l = 1; l < this->Levels.size(); ++l)
    {
      distances.push_back(this->Levels[l].Offset - this->Levels[l - 1].Offset);
    }
    return Median(std::move(distances));
  }
};
}

#endif
