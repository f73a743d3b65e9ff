// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkContourSetAlgorithm.h"

#include "Base/Text.h"
#include "ContourConversion.h"
#include "Ranks.h"
#include "RunCore.h"
#include "SliceBlocks.h"
#include "SurfaceBlocks.h"

#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkPolyData.h"

#include <algorithm>

void vtkContourSetAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "HoleRule: " << this->HoleRule << endl;
  os << indent << "OpenLines: " << this->OpenLines << endl;
  os << indent << "PlaneTolerance: " << this->PlaneTolerance << endl;
  os << indent << "SnapTolerance: " << this->SnapTolerance << endl;
}

recon::ContourSet vtkContourSetAlgorithm::ReadContours(
  vtkPolyData* input, bool parallel, recon::Monitor& monitor)
{
  if (!this->Spread.empty())
  {
    throw recon::Error(this->Spread);
  }
  recon::ContourSetOptions options;
  options.Parallel = parallel;
  options.PlaneTolerance = this->PlaneTolerance;
  options.SnapTolerance = this->SnapTolerance;
  options.Holes = static_cast<recon::HoleRule>(this->HoleRule);
  options.OpenLines = static_cast<recon::OpenLineRule>(this->OpenLines);
  recon::ContourSet contours = recon::ReadContours(input, options, monitor);
  if (!contours.Warning.empty())
  {
    vtkWarningMacro(<< contours.Warning);
  }
  return contours;
}

recon::ContourSet vtkContourSetAlgorithm::ReadContoursOfSolid(
  vtkPolyData* input, bool parallel, recon::Monitor& monitor)
{
  if (this->Slices.empty())
  {
    return this->ReadContours(input, parallel, monitor);
  }
  if (input != this->Slices.front())
  {
    throw recon::NothingLeft(
      "This block is a slice of the object that the first block has become.");
  }
  recon::ContourSet contours =
    this->ReadContours(recon::JoinBlocks(this->Slices), parallel, monitor);
  contours.Report.insert(contours.Report.begin(),
    recon::Counted(this->Slices.size(), "block") +
      " of the collection lie in a plane each: taken as slices of one object.");
  return contours;
}

void vtkContourSetAlgorithm::LookAtRanks(vtkDataObject* input, const recon::Ranks& ranks)
{
  this->Spread.clear();
  if (!ranks.AreSeveral())
  {
    return;
  }
  try
  {
    this->Spread = ranks.FindSpread(input);
    const auto blocks = recon::ListPolyData(input);
    const auto filled = std::count_if(blocks.begin(), blocks.end(),
      [](const recon::NamedPolyData& block) { return block.Data->GetNumberOfCells() > 0; });
    const auto flat = static_cast<int>(recon::FindFlatBlocks(input).size());
    const std::vector<int> all = ranks.Gather({ static_cast<int>(filled), flat });
    int slices = 0;
    int holders = 0;
    bool areSlices = true;
    for (std::size_t r = 0; r < all.size(); r += 2)
    {
      slices += all[r + 1];
      holders += all[r] > 0 ? 1 : 0;
      areSlices = areSlices && all[r] == all[r + 1];
    }
    if (!areSlices)
    {
      this->Slices.clear();
    }
    else if (slices > 1 && holders > 1)
    {
      this->Spread = std::to_string(holders) + " of " + std::to_string(ranks.GetCount()) +
        " ranks have slices of one object";
    }
  }
  catch (const recon::Error& error)
  {
    this->Spread = error.what();
    return;
  }
  if (!this->Spread.empty())
  {
    this->Spread +=
      ", and contours are needed together: put Contour Regions before this, which brings them so.";
  }
}

vtkTypeBool vtkContourSetAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_NOT_GENERATED()))
  {
    vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
    // Asked for the collection first, and then for every block.
    const auto block = std::find(this->Pending.begin(), this->Pending.end(), input);
    if (block != this->Pending.end())
    {
      this->Pending.erase(block);
    }
    else
    {
      this->Slices = recon::FindSliceBlocks(input);
      this->LookAtRanks(input, recon::Ranks(inputVector[0]));
      this->Pending.clear();
      for (const recon::NamedPolyData& pending : recon::ListPolyData(input))
      {
        if (pending.Data != input)
        {
          this->Pending.push_back(pending.Data);
        }
      }
    }
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}
