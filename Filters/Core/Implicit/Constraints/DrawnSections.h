// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file DrawnSections.h
 * @brief Where an implicit function is on another side than what was drawn: on the drawn planes, also
 * where they are empty, and between two of them where both say the same.
 *
 * Why: margins tell the side next to contours only. Where a branch ends, nothing on the next planes
 * says so, and a smooth function goes on for several of them; and a hole that is narrow beside the
 * gap between its slices closes to a waist between them.
 */
#ifndef recon_DrawnSections_h
#define recon_DrawnSections_h

#include "Base/Monitor.h"
#include "Implicit/Constraints/Constraints.h"
#include "Implicit/FastMultipole/FunctionEvaluator.h"
#include "Planar/PlanarEdges.h"

#include <cstddef>
#include <string>
#include <vector>

namespace recon
{
/// A place whose side the contours tell.
struct ToldPlace
{
  Point3 Place{};
  double Value = 0; ///< estimate of the distance to the surface, > 0 inside; 0 on a contour
  double Room = 0;  ///< distance to the contours, in their planes
};

/**
 * @class DrawnSections
 * @brief The levels of a set of parallel contours as sections that a function should have.
 */
class DrawnSections
{
public:
  /**
   * @param drawn levels all parallel; outlives this. @param cell the size of what is looked at.
   * @param empty further planes; those that are not parallel to the levels are not used.
   */
  DrawnSections(const ContourSet& drawn, const std::vector<EmptyPlane>& empty, double cell,
    const SectionTolerances& tolerances = {});

  struct Disagreements
  {
    /// Well spread, deepest first: where a constraint would help most.
    std::vector<ToldPlace> Places;
    std::vector<int> Sections; ///< that disagree, in order
  };

  /// @param look number of the look at such a function: each has other samples. @throws Aborted
  Disagreements Compare(
    const ImplicitFunction& function, int threads, Monitor& monitor, int look = 0) const;

  /// "the plane at 12", "between the planes at 12 and 15".
  std::string NameOf(int section) const;

private:
  struct Section
  {
    double Height = 0; ///< along the first level's normal
    PlanarFrame Frame;
    double Offset = 0;
    int Edges = -1; ///< index into EdgesOf; -1: empty
    int Level = -1;
    double Area = 0;   ///< drawn
    double Finest = 1; ///< squares, in cells
  };
  struct Square;
  struct Between;

  void ComparePlanes(const FunctionEvaluator& evaluator, int threads, int look, Monitor& monitor,
    std::vector<std::vector<ToldPlace>>& places, std::vector<int>& wrong) const;
  void CompareContours(const FunctionEvaluator& evaluator, Monitor& monitor,
    std::vector<std::vector<ToldPlace>>& places, std::vector<int>& wrong) const;
  void CompareBetween(const FunctionEvaluator& evaluator, Monitor& monitor,
    std::vector<std::vector<ToldPlace>>& places, std::vector<int>& wrong) const;
  std::vector<Square> CoarseSquares(int look) const;
  void SampleContour(int section, int other, int contour, double part, Between& samples) const;
  double RoomAt(int section, const Point3& p, double limit) const;
  int SideAt(int section, const Point3& p) const;
  double ValueAt(int section, const Point3& p, int side, double room) const;
  double GapAt(int section, int step) const;
  Point3 NearestDrawn(int section, const Point3& p) const;
  void Spread(int section, const std::vector<ToldPlace>& from, std::vector<ToldPlace>& to) const;

  const ContourSet& Drawn;
  double Cell;
  SectionTolerances Tolerances;
  Box3 Box;
  double Gap = 0;                ///< median distance of neighbouring sections
  std::vector<Section> Sections; ///< by height
  std::vector<PlanarEdges> EdgesOf;
};
}

#endif
