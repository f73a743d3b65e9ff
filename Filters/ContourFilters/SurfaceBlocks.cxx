// SPDX-License-Identifier: GPL-3.0-or-later
#include "SurfaceBlocks.h"

#include "Base/Monitor.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace recon
{
namespace
{
std::string NameIn(vtkInformation* info)
{
  const char* name = info && info->Has(vtkCompositeDataSet::NAME())
    ? info->Get(vtkCompositeDataSet::NAME())
    : nullptr;
  return name ? name : "";
}

/// The parts of a partitioned data set have its name, which the collection knows.
std::vector<NamedPolyData> ListParts(vtkPartitionedDataSetCollection* collection)
{
  std::vector<NamedPolyData> found;
  for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
  {
    const std::string name =
      collection->HasMetaData(i) ? NameIn(collection->GetMetaData(i)) : std::string();
    for (unsigned int p = 0; p < collection->GetNumberOfPartitions(i); ++p)
    {
      if (auto* part = vtkPolyData::SafeDownCast(collection->GetPartitionAsDataObject(i, p)))
      {
        found.push_back({ name, part });
      }
    }
  }
  return found;
}
}

std::vector<NamedPolyData> ListPolyData(vtkDataObject* object)
{
  if (auto* polyData = vtkPolyData::SafeDownCast(object))
  {
    return { { "", polyData } };
  }
  if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(object))
  {
    return ListParts(collection);
  }
  std::vector<NamedPolyData> found;
  if (auto* tree = vtkDataObjectTree::SafeDownCast(object))
  {
    const auto leaf = vtk::TakeSmartPointer(tree->NewTreeIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      if (auto* polyData = vtkPolyData::SafeDownCast(leaf->GetCurrentDataObject()))
      {
        found.push_back(
          { leaf->HasCurrentMetaData() ? NameIn(leaf->GetCurrentMetaData()) : "", polyData });
      }
    }
  }
  return found;
}

std::vector<NamedPolyData> ListSurfaces(vtkDataObject* object)
{
  std::vector<NamedPolyData> surfaces = ListPolyData(object);
  surfaces.erase(std::remove_if(surfaces.begin(), surfaces.end(),
                   [](const NamedPolyData& block) { return block.Data->GetNumberOfPolys() == 0; }),
    surfaces.end());
  if (surfaces.empty())
  {
    throw Error("No block of the collection has a surface to write.");
  }
  return surfaces;
}

std::vector<std::string> NamesOf(const std::vector<NamedPolyData>& blocks)
{
  std::vector<std::string> names;
  for (const NamedPolyData& block : blocks)
  {
    names.push_back(block.Name);
  }
  return names;
}

std::vector<vtkPolyData*> MatchContours(
  const std::vector<NamedPolyData>& surfaces, vtkDataObject* contours)
{
  std::vector<vtkPolyData*> matched(surfaces.size(), nullptr);
  if (!contours)
  {
    return matched;
  }
  const auto candidates = ListPolyData(contours);
  if (vtkPolyData::SafeDownCast(contours))
  {
    std::fill(matched.begin(), matched.end(), candidates.front().Data);
    return matched;
  }
  bool any = false;
  for (std::size_t s = 0; s < surfaces.size(); ++s)
  {
    const auto same = std::find_if(candidates.begin(), candidates.end(),
      [&](const NamedPolyData& c) { return !c.Name.empty() && c.Name == surfaces[s].Name; });
    if (same != candidates.end())
    {
      matched[s] = same->Data;
      any = true;
    }
  }
  if (!any && candidates.size() == surfaces.size())
  {
    std::transform(candidates.begin(), candidates.end(), matched.begin(),
      [](const NamedPolyData& c) { return c.Data; });
    any = true;
  }
  if (!any && !surfaces.empty())
  {
    throw Error("None of the " + std::to_string(candidates.size()) +
      " blocks of contours has the name of a surface, and there are " +
      std::to_string(surfaces.size()) +
      " surfaces: connect the contours that the surface was made from.");
  }
  return matched;
}
}
