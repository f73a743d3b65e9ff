// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkContourSetAlgorithm.h"

#include "Base/Text.h"
#include "ContourConversion.h"
#include "RunCore.h"
#include "SliceBlocks.h"

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

vtkTypeBool vtkContourSetAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_NOT_GENERATED()))
  {
    vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
    // Asked for the collection first, and then for every block.
    const bool isSlice =
      std::find(this->Slices.begin(), this->Slices.end(), input) != this->Slices.end();
    if (!isSlice)
    {
      this->Slices = recon::FindSliceBlocks(input);
    }
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}
