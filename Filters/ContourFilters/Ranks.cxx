// SPDX-License-Identifier: GPL-3.0-or-later
#include "Ranks.h"

#include "Base/Monitor.h"
#include "Pieces.h"
#include "SliceBlocks.h"
#include "SurfaceBlocks.h"

#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>

namespace recon
{
namespace
{
constexpr int BlockTag = 7301; ///< of messages with a block

constexpr const char* Seams =
  ", and a surface in pieces has seams: make it on one rank, by Aggregate "
  "Dataset before the filter that made it.";

using Blocks = std::vector<vtkSmartPointer<vtkPolyData>>;

bool HasSomething(vtkPolyData* block)
{
  return block && block->GetNumberOfPoints() + block->GetNumberOfCells() > 0;
}

/// Of each partitioned data set the most partitions that a rank has.
std::vector<int> PartitionCounts(vtkPartitionedDataSetCollection* collection, const Ranks& ranks)
{
  std::vector<int> counts;
  for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
  {
    counts.push_back(static_cast<int>(collection->GetNumberOfPartitions(i)));
  }
  const std::vector<int> all = ranks.Gather(counts);
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    int& most = counts[i % counts.size()];
    most = std::max(most, all[i]);
  }
  return counts;
}

vtkSmartPointer<vtkDataObjectTreeIterator> LeavesOf(vtkDataObjectTree* tree)
{
  auto leaves = vtk::TakeSmartPointer(tree->NewTreeIterator());
  leaves->SkipEmptyNodesOff();
  return leaves;
}

/// What has to be the same on all ranks: how many blocks there are, or that there are none.
int CountOf(vtkDataObject* data)
{
  if (!data || vtkPolyData::SafeDownCast(data))
  {
    return data ? -1 : -2;
  }
  if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
  {
    return static_cast<int>(collection->GetNumberOfPartitionedDataSets());
  }
  int count = 0;
  if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
  {
    const auto leaves = LeavesOf(tree);
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      ++count;
    }
  }
  return count;
}

void CheckStructure(vtkDataObject* data, const Ranks& ranks)
{
  const std::vector<int> counts = ranks.Gather({ CountOf(data) });
  if (std::any_of(counts.begin(), counts.end(), [&](int c) { return c != counts.front(); }))
  {
    throw Error("The input has other blocks on some ranks than on the first, so that a region "
                "cannot be told by its place: put Merge Blocks or Aggregate Dataset before this.");
  }
}

/// All places for blocks, in the same order on all ranks; nullptr where this one has nothing.
Blocks BlocksIn(vtkDataObject* data, const Ranks& ranks)
{
  CheckStructure(data, ranks);
  if (auto* polyData = vtkPolyData::SafeDownCast(data))
  {
    return { polyData };
  }
  Blocks blocks;
  if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
  {
    const std::vector<int> counts = PartitionCounts(collection, ranks);
    for (unsigned int i = 0; i < counts.size(); ++i)
    {
      for (unsigned int p = 0; p < static_cast<unsigned int>(counts[i]); ++p)
      {
        blocks.emplace_back(p < collection->GetNumberOfPartitions(i)
            ? vtkPolyData::SafeDownCast(collection->GetPartitionAsDataObject(i, p))
            : nullptr);
      }
    }
  }
  else if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
  {
    const auto leaves = LeavesOf(tree);
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      blocks.emplace_back(vtkPolyData::SafeDownCast(leaves->GetCurrentDataObject()));
    }
  }
  return blocks;
}

/// The structure of the data with these blocks in their places.
vtkSmartPointer<vtkDataObject> Assemble(
  vtkDataObject* data, const Blocks& blocks, const Ranks& ranks)
{
  if (blocks.empty() || vtkPolyData::SafeDownCast(data))
  {
    return blocks.empty() ? data : blocks.front().Get();
  }
  auto made = vtk::TakeSmartPointer(vtkDataObjectTree::SafeDownCast(data->NewInstance()));
  made->CopyStructure(vtkDataObjectTree::SafeDownCast(data));
  made->GetFieldData()->ShallowCopy(data->GetFieldData());
  auto block = blocks.begin();
  if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(made))
  {
    const std::vector<int> counts =
      PartitionCounts(vtkPartitionedDataSetCollection::SafeDownCast(data), ranks);
    for (unsigned int i = 0; i < counts.size(); ++i)
    {
      collection->SetNumberOfPartitions(i, static_cast<unsigned int>(counts[i]));
      for (unsigned int p = 0; p < static_cast<unsigned int>(counts[i]); ++p)
      {
        collection->SetPartition(i, p, *block++);
      }
    }
    return made;
  }
  const auto leaves = LeavesOf(made);
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    made->SetDataSet(leaves, *block++);
  }
  return made;
}

/// For each block the ranks that have something of it, in their order.
std::vector<std::vector<int>> HoldersOf(const Blocks& blocks, const Ranks& ranks)
{
  std::vector<int> mine;
  for (vtkPolyData* block : blocks)
  {
    mine.push_back(HasSomething(block) ? 1 : 0);
  }
  const std::vector<int> all = ranks.Gather(mine);
  std::vector<std::vector<int>> holders(blocks.size());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (all[i] != 0)
    {
      holders[i % blocks.size()].push_back(static_cast<int>(i / blocks.size()));
    }
  }
  return holders;
}

std::string SpreadIn(const std::vector<std::vector<int>>& holders, int ranks)
{
  const auto spread = std::find_if(holders.begin(), holders.end(),
    [](const std::vector<int>& holding) { return holding.size() > 1; });
  if (spread == holders.end())
  {
    return {};
  }
  const std::string which =
    holders.size() > 1 ? "block " + std::to_string(spread - holders.begin()) : "the input";
  return std::to_string(spread->size()) + " of " + std::to_string(ranks) +
    " ranks have a part of " + which;
}

/// A block that stands for itself: neither its arrays nor its field data are anybody's else.
vtkSmartPointer<vtkPolyData> Detached(vtkPolyData* block)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(block);
  vtkNew<vtkFieldData> field;
  field->ShallowCopy(block->GetFieldData());
  copy->SetFieldData(field);
  ForgetOwner(copy);
  return copy;
}

/// Parts of a block, in the order of ranks, as one.
vtkSmartPointer<vtkPolyData> Joined(const Blocks& parts)
{
  if (parts.size() == 1)
  {
    return Detached(parts.front());
  }
  const auto joined = JoinBlocks(std::vector<vtkPolyData*>(parts.begin(), parts.end()));
  joined->GetFieldData()->ShallowCopy(parts.front()->GetFieldData());
  return Detached(joined);
}

/// On the root the whole block; what this rank has elsewhere.
vtkSmartPointer<vtkPolyData> CollectOnRoot(vtkPolyData* mine, const std::vector<int>& holders,
  const Ranks& ranks, vtkMultiProcessController* controller)
{
  if (!ranks.IsRoot())
  {
    if (HasSomething(mine))
    {
      controller->Send(mine, 0, BlockTag);
    }
    return mine;
  }
  if (holders.empty())
  {
    return mine ? Detached(mine) : nullptr;
  }
  Blocks parts;
  for (const int holder : holders)
  {
    if (holder == 0)
    {
      parts.emplace_back(mine);
      continue;
    }
    auto part = vtkSmartPointer<vtkPolyData>::New();
    controller->Receive(part, holder, BlockTag);
    parts.push_back(part);
  }
  return Joined(parts);
}
}

Ranks::Ranks() : Controller(vtkMultiProcessController::GetGlobalController())
{
  if (this->Controller)
  {
    this->Mine = this->Controller->GetLocalProcessId();
    this->Count = this->Controller->GetNumberOfProcesses();
  }
}

Ranks::Ranks(vtkInformationVector* inputVector)
  : Ranks(RequestedPiece(inputVector).Count > 1 ? Ranks() : Ranks(nullptr, 0, 1))
{
}

std::vector<int> Ranks::Gather(const std::vector<int>& values) const
{
  if (!this->AreSeveral())
  {
    return values;
  }
  std::vector<int> all(values.size() * static_cast<std::size_t>(this->Count));
  if (!values.empty())
  {
    this->Controller->AllGather(values.data(), all.data(), static_cast<vtkIdType>(values.size()));
  }
  return all;
}

std::vector<vtkMultiProcessStream> Ranks::GatherOnRoot(const vtkMultiProcessStream& sent) const
{
  std::vector<vtkMultiProcessStream> received;
  if (!this->AreSeveral())
  {
    received.push_back(sent);
    return received;
  }
  this->Controller->Gather(sent, received, 0);
  return received;
}

int Ranks::FromRoot(int value) const
{
  if (this->AreSeveral())
  {
    this->Controller->Broadcast(&value, 1, 0);
  }
  return value;
}

vtkSmartPointer<vtkDataObject> Ranks::BringToRoot(vtkDataObject* data, SpreadBlocks how) const
{
  if (!this->AreSeveral())
  {
    return data;
  }
  Blocks blocks = BlocksIn(data, *this);
  const std::vector<std::vector<int>> holders = HoldersOf(blocks, *this);
  const std::string spread = SpreadIn(holders, this->Count);
  if (how == SpreadBlocks::Refuse && !spread.empty())
  {
    throw Error(spread + Seams);
  }
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    blocks[b] = CollectOnRoot(blocks[b], holders[b], *this, this->Controller);
  }
  const auto made = Assemble(data, blocks, *this);
  return this->IsRoot() ? made : nullptr;
}

vtkSmartPointer<vtkDataObject> Ranks::BringToAll(vtkDataObject* data, SpreadBlocks how) const
{
  if (!this->AreSeveral())
  {
    return data;
  }
  const auto onRoot = this->BringToRoot(data, how);
  Blocks blocks = BlocksIn(this->IsRoot() ? onRoot.Get() : data, *this);
  const std::vector<std::vector<int>> holders = HoldersOf(blocks, *this);
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    if (holders[b].empty())
    {
      continue; // nobody has anything, and what each has to say of it stays
    }
    blocks[b] = this->IsRoot() ? blocks[b] : vtkSmartPointer<vtkPolyData>::New();
    this->Controller->Broadcast(blocks[b].Get(), 0);
  }
  return Assemble(data, blocks, *this);
}

std::vector<BlockPlace> Ranks::FindPlaces(vtkDataObject* data) const
{
  const Blocks blocks = BlocksIn(data, *this);
  const std::vector<std::vector<int>> holders = HoldersOf(blocks, *this);
  const std::string spread = SpreadIn(holders, this->Count);
  if (!spread.empty())
  {
    throw Error(spread + Seams);
  }
  std::vector<int> mine;
  for (vtkPolyData* block : blocks)
  {
    mine.push_back(block ? 1 : 0);
  }
  const std::vector<int> all = this->Gather(mine);
  std::vector<BlockPlace> places;
  int number = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    int first = 0; // rank that has the block, be it empty
    while (first < this->Count && all[static_cast<std::size_t>(first) * blocks.size() + b] == 0)
    {
      ++first;
    }
    if (blocks[b])
    {
      places.push_back({ number, this->Mine == (holders[b].empty() ? first : holders[b].front()) });
    }
    number += first < this->Count ? 1 : 0;
  }
  return places;
}

std::string Ranks::FindSpread(vtkDataObject* data) const
{
  return this->AreSeveral() ? SpreadIn(HoldersOf(BlocksIn(data, *this), *this), this->Count)
                            : std::string();
}
}
