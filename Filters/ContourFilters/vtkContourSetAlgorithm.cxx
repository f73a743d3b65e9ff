// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkContourSetAlgorithm.h"

#include "ContourConversion.h"

#include "vtkPolyData.h"

void vtkContourSetAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "HoleRule: " << this->HoleRule << endl;
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
  return recon::ReadContours(input, options, monitor);
}
