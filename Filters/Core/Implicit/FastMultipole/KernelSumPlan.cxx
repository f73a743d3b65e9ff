// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/FastMultipole/KernelSumPlan.h"

#include <algorithm>
#include <cstdlib>

namespace recon
{
namespace
{
/// Pairs of points up to which two far boxes are summed directly: a translation costs as much.
constexpr std::int64_t DirectPairs = 256;
/// Places that are expected in a box of the plan for everywhere.
constexpr std::int64_t ExpectedPlaces = 32;
/// Points near a box of that plan that make it split.
constexpr std::int64_t ManyNear = 1024;
/// Far pairs in a piece of work.
constexpr std::size_t ChunkPairs = 2048;

bool Touch(const OctreeBox& a, const OctreeBox& b, std::array<int, 3>& offset)
{
  int largest = 0;
  for (int k = 0; k < 3; ++k)
  {
    offset[k] = a.Cell[k] - b.Cell[k];
    largest = std::max(largest, std::abs(offset[k]));
  }
  return largest <= 1;
}
}

KernelSumPlan::KernelSumPlan(const KernelOctree& sources) : Sources(sources)
{
  this->TouchingStart = { 0 };
  for (int level = 0; level < sources.Levels(); ++level)
  {
    this->VisitLevel(level);
  }
  this->Finish();
}

KernelSumPlan::KernelSumPlan(const KernelOctree& sources, Everywhere)
  : Sources(sources),
    Own(std::make_unique<KernelOctree>())
{
  this->TouchingStart = { 0 };
  this->VisitLevel(0);
  while (this->Own->SplitLastLevel([this](int box) { return this->HasManyNear(box); }))
  {
    this->VisitLevel(this->Own->Levels() - 1);
  }
  this->Finish();
}

void KernelSumPlan::VisitLevel(int level)
{
  const KernelOctree& targets = this->Targets();
  const std::vector<OctreeBox>& boxes = this->Sources.Boxes();
  for (std::int32_t t = targets.LevelBegin(level); t < targets.LevelEnd(level); ++t)
  {
    const std::int32_t parent = targets.Boxes()[t].Parent;
    if (parent < 0)
    {
      if (!boxes.empty())
      {
        this->Meet(t, 0);
      }
    }
    else
    {
      for (std::size_t i = this->TouchingStart[parent]; i < this->TouchingStart[parent + 1]; ++i)
      {
        const OctreeBox& box = boxes[this->Touching[i].Source];
        for (std::int32_t c = 0; c < box.Children; ++c)
        {
          this->Meet(t, box.FirstChild + c);
        }
      }
    }
    this->TouchingStart.push_back(this->Touching.size());
  }
}

void KernelSumPlan::Meet(std::int32_t target, std::int32_t source)
{
  const OctreeBox& t = this->Targets().Boxes()[target];
  const OctreeBox& s = this->Sources.Boxes()[source];
  std::array<int, 3> offset{};
  if (Touch(t, s, offset))
  {
    (s.IsLeaf() ? this->NearBoxes : this->Touching).push_back({ target, source });
    return;
  }
  const std::int64_t places = this->Own ? ExpectedPlaces : t.Count();
  if (places * s.Count() <= DirectPairs)
  {
    this->NearBoxes.push_back({ target, source });
    return;
  }
  const OffsetClass turned = ChebyshevOperators::Classify(offset);
  this->Far.push_back({ target, source, turned.Turn });
  this->FarClass.push_back(turned.Class);
}

bool KernelSumPlan::HasManyNear(std::int32_t target) const
{
  std::int64_t sources = 0;
  for (std::size_t i = this->TouchingStart[target]; i < this->TouchingStart[target + 1]; ++i)
  {
    sources += this->Sources.Boxes()[this->Touching[i].Source].Count();
  }
  return sources > ManyNear;
}

void KernelSumPlan::Finish()
{
  const std::vector<OctreeBox>& targets = this->Targets().Boxes();
  for (std::size_t t = 0; t < targets.size(); ++t)
  {
    if (targets[t].IsLeaf())
    {
      this->TargetLeaves.push_back(static_cast<std::int32_t>(t));
      for (std::size_t i = this->TouchingStart[t]; i < this->TouchingStart[t + 1]; ++i)
      {
        this->NearBoxes.push_back(this->Touching[i]);
      }
    }
  }
  this->SortFar();
  this->SortNear();
  this->Touching = {};
  this->TouchingStart = {};
}

void KernelSumPlan::SortFar()
{
  const std::vector<OctreeBox>& targets = this->Targets().Boxes();
  this->Reached.assign(targets.size(), 0);
  for (const FarPair& pair : this->Far)
  {
    this->Reached[pair.Target] = 1;
  }
  for (std::size_t t = 0; t < targets.size(); ++t)
  {
    // Parents come before their children.
    if (targets[t].Parent >= 0 && this->Reached[targets[t].Parent] != 0)
    {
      this->Reached[t] = 1;
    }
  }
  // The pairs come by target, so by level.
  std::size_t from = 0;
  for (std::size_t i = 1; i <= this->Far.size(); ++i)
  {
    const bool end = i == this->Far.size();
    const bool newTarget = end || this->Far[i].Target != this->Far[i - 1].Target;
    const bool newLevel =
      end || targets[this->Far[i].Target].Level != targets[this->Far[i - 1].Target].Level;
    if (newLevel || (newTarget && i - from >= ChunkPairs))
    {
      this->AppendChunk(from, i);
      from = i;
    }
  }
  this->FarClass = {};
}

void KernelSumPlan::AppendChunk(std::size_t from, std::size_t to)
{
  FarChunk chunk;
  chunk.Level = this->Targets().Boxes()[this->Far[from].Target].Level;
  std::array<std::vector<FarPair>, ChebyshevOperators::Classes> byClass;
  for (std::size_t i = from; i < to; ++i)
  {
    byClass[this->FarClass[i]].push_back(this->Far[i]);
  }
  auto next = static_cast<std::int32_t>(from);
  for (int c = 0; c < ChebyshevOperators::Classes; ++c)
  {
    chunk.Start[c] = next;
    std::copy(byClass[c].begin(), byClass[c].end(), this->Far.begin() + next);
    next += static_cast<std::int32_t>(byClass[c].size());
  }
  chunk.Start[ChebyshevOperators::Classes] = next;
  this->FarChunks.push_back(chunk);
}

void KernelSumPlan::SortNear()
{
  const std::vector<OctreeBox>& targets = this->Targets().Boxes();
  std::vector<std::vector<SourceRange>> own(targets.size());
  for (const Listed& near : this->NearBoxes)
  {
    const OctreeBox& box = this->Sources.Boxes()[near.Source];
    own[near.Box].push_back({ box.From, box.To });
  }
  this->NearBoxes = {};
  this->NearStart = { 0 };
  std::vector<SourceRange> all;
  for (const std::int32_t leaf : this->TargetLeaves)
  {
    all.clear();
    for (std::int32_t t = leaf; t >= 0; t = targets[t].Parent)
    {
      all.insert(all.end(), own[t].begin(), own[t].end());
    }
    std::sort(all.begin(), all.end(),
      [](const SourceRange& a, const SourceRange& b) { return a.From < b.From; });
    for (const SourceRange& range : all)
    {
      if (this->Near.size() > this->NearStart.back() && this->Near.back().To == range.From)
      {
        this->Near.back().To = range.To;
      }
      else
      {
        this->Near.push_back(range);
      }
    }
    this->NearStart.push_back(this->Near.size());
  }
}
}
