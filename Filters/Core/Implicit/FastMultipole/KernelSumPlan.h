// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file KernelSumPlan.h
 * @brief Which boxes of sources act on which boxes of targets, and how.
 */
#ifndef recon_KernelSumPlan_h
#define recon_KernelSumPlan_h

#include "Implicit/FastMultipole/ChebyshevOperators.h"
#include "Implicit/FastMultipole/ExpansionLoops.h"
#include "Implicit/FastMultipole/KernelOctree.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace recon
{
/// A far box of sources and a box of targets of the same level.
struct FarPair
{
  std::int32_t Target;
  std::int32_t Source;
  std::int32_t Turn; ///< of ChebyshevOperators
};

/// Pairs of some neighbouring targets of one level, sorted by the class of their offset. No target
/// is in two chunks, so chunks may be worked on side by side.
struct FarChunk
{
  int Level = 0;
  std::array<std::int32_t, ChebyshevOperators::Classes + 1> Start{};
};

/**
 * @class KernelSumPlan
 * @brief The lists of a fast sum from one octree to another.
 *
 * Two boxes of one level are far where they do not touch. A target box takes its far boxes from the
 * children of those that touch its parent; what touches a leaf is near and summed directly.
 */
class KernelSumPlan
{
public:
  /// From a tree's points to themselves; the tree is shared.
  explicit KernelSumPlan(const KernelOctree& sources);
  /// From a tree's points to any place in the root cube: boxes are split until few points are near.
  struct Everywhere
  {
  };
  KernelSumPlan(const KernelOctree& sources, Everywhere);

  const KernelOctree& Targets() const { return this->Own ? *this->Own : this->Sources; }
  const std::vector<FarPair>& Pairs() const { return this->Far; }
  const std::vector<FarChunk>& Chunks() const { return this->FarChunks; }
  const std::vector<std::int32_t>& Leaves() const { return this->TargetLeaves; }
  /// The near sources of the i-th leaf.
  const SourceRange* NearBegin(std::size_t leaf) const
  {
    return this->Near.data() + this->NearStart[leaf];
  }
  std::size_t NearCount(std::size_t leaf) const
  {
    return this->NearStart[leaf + 1] - this->NearStart[leaf];
  }
  /// Does anything far act on the box, or on one that it is part of?
  bool HasFar(std::int32_t target) const { return this->Reached[target] != 0; }

private:
  struct Listed
  {
    std::int32_t Box;
    std::int32_t Source;
  };

  void VisitLevel(int level);
  void Meet(std::int32_t target, std::int32_t source);
  bool HasManyNear(std::int32_t target) const;
  void Finish();
  void SortFar();
  void AppendChunk(std::size_t from, std::size_t to);
  void SortNear();

  const KernelOctree& Sources;
  std::unique_ptr<KernelOctree> Own;
  /// Boxes of sources that touch a target's box and have children, by target.
  std::vector<Listed> Touching;
  std::vector<std::size_t> TouchingStart;
  std::vector<FarPair> Far;
  std::vector<std::int32_t> FarClass; ///< while the lists are made
  std::vector<FarChunk> FarChunks;
  std::vector<Listed> NearBoxes; ///< while the lists are made
  std::vector<std::int32_t> TargetLeaves;
  std::vector<SourceRange> Near;
  std::vector<std::size_t> NearStart;
  std::vector<char> Reached;
};
}

#endif
