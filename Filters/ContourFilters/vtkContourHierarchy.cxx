// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkContourHierarchy.h"

#include "ContourConversion.h"
#include "Contours/ContourSetBuilder.h"
#include "InputArrays.h"
#include "vtkContourMonitor.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkContourHierarchy);

void vtkContourHierarchy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ParallelPlanesOnly: " << (this->ParallelPlanesOnly ? "On" : "Off") << endl;
  os << indent << "HoleRule: " << this->HoleRule << endl;
  os << indent << "PlaneTolerance: " << this->PlaneTolerance << endl;
}

int vtkContourHierarchy::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (!input || !output)
  {
    vtkErrorMacro(
      "Contour Hierarchy needs contours as poly data: connect a contour reader or Slice.");
    return 0;
  }
  if (input->GetNumberOfCells() == 0)
  {
    // Regions of interest without contours are common; in a collection they must not stop the
    // others.
    recon::PassInputFieldData(input, output);
    return 1;
  }
  if (recon::PassPoints(this, input, output))
  {
    return 1;
  }
  try
  {
    vtkContourMonitor monitor(this);
    const recon::ConvertedLoops loops = recon::ToLoopSoup(input);
    recon::ContourSetOptions options;
    options.Parallel = this->ParallelPlanesOnly;
    options.PlaneTolerance = this->PlaneTolerance;
    options.Holes = static_cast<recon::HoleRule>(this->HoleRule);
    const recon::ContourSet set = recon::BuildContourSet(loops.Soup, options, monitor);
    std::vector<std::string> report = recon::GetReport(input);
    report.insert(report.end(), loops.Report.begin(), loops.Report.end());
    recon::ToPolyData(set, report, output);
    recon::PassCellData(set, input, output);
    recon::PassInputFieldData(input, output);
    return 1;
  }
  catch (const recon::Aborted&)
  {
    output->Initialize();
    return 1;
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
}
