// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file KeptStages.h
 * @brief The stages of the last run, from which the next takes what a change of contours does not reach.
 *
 * For contours that are edited one at a time. Everything is compared by its bytes, and what comes out
 * is what a run from nothing gives, to the last bit.
 *
 * How far a change reaches. A level gets points from the levels beside it, a slab is made of two such
 * levels, what is lifted in it depends on what is covered on both, and so on the slabs beside it: after
 * one round (PolyhedralStages::Rounds) a level depends on the contours of the three levels on either side
 * of it. Each further round adds points by what was lifted, and so reaches two levels farther. A part of the
 * stack that begins and ends as far again beyond the reach of a change is made anew, and its middle taken.
 * Where two neighbouring triangulations of that part, in any round, are those of the last run, so are the
 * tetrahedra between them: they depend on nothing else but what is joined.
 */
#ifndef recon_KeptStages_h
#define recon_KeptStages_h

#include "Contours/ContourSet.h"
#include "Polyhedral/PolyhedralStages.h"

#include <optional>
#include <vector>

namespace recon
{
class KeptStages
{
public:
  /// The same as BuildPolyhedralStages; valid until the next call of any member. What takes more memory than a user
  /// may want to lend for the next run is not kept: the sink hears of all, as it is finished.
  const PolyhedralStages& Update(const ContourSet& contours, const PolyhedralOptions& options,
    Monitor& monitor, double progressEnd, TetrahedraWanted wanted, const StagesSink& sink = {});

  /// Levels that the last Update had to make, of all.
  std::size_t LevelsMade() const { return this->Made; }

private:
  /// From level First up to, without, level End; empty where First is not below End.
  struct Range
  {
    int First;
    int End;
    Range Grown(int by, int levels) const;
    void Include(int level);
  };

  bool IsOfUse(
    const ContourSet& contours, const PolyhedralOptions& options, TetrahedraWanted wanted) const;
  KnownOverlaps OverlapsWithout(const Range& changed, const ContourSet& contours) const;
  /// @returns whether that was possible and worth it
  bool UpdatePart(const ContourSet& contours, const PolyhedralOptions& options, Monitor& monitor,
    double progressEnd, TetrahedraWanted wanted);
  std::optional<SlabTetrahedra> KnownDiagram(int slab, const ContourSet& contours, int firstContour,
    const LevelTriangulation& lower, const LevelTriangulation& upper) const;
  void Renumber(const ContourSet& contours);
  void TakeOver(
    PolyhedralStages& part, const Range& window, const Range& reached, int firstContour);

  bool HasStages = false;
  std::size_t Made = 0;
  ContourSet Contours;
  PolyhedralOptions Options;
  TetrahedraWanted Wanted = TetrahedraWanted::All;
  PolyhedralStages Stages;
};
}

#endif
