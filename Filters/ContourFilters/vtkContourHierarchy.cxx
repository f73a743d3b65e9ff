// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkContourHierarchy.h"

#include "ContourConversion.h"
#include "RunCore.h"
#include "vtkContourMonitor.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkContourHierarchy);

void vtkContourHierarchy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ParallelPlanesOnly: " << (this->ParallelPlanesOnly ? "On" : "Off") << endl;
}

int vtkContourHierarchy::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  return recon::RunCore(this, input, recon::NeedsContours, { output },
    [&]
    {
      vtkContourMonitor monitor(this);
      const recon::ContourSet set = this->ReadContours(input, this->ParallelPlanesOnly, monitor);
      recon::ToPolyData(set, output);
      recon::PassCellData(set, input, output);
      output->GetCellData()->SetActiveScalars("ContourId"); // which a view colours by
      recon::FinishOutput(input, set.Report, output);
    });
}
