// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkImplicitFunctionFit.h"

#include "ContourConversion.h"
#include "ImplicitData.h"
#include "ImplicitOptions.h"
#include "RunCore.h"
#include "vtkContourMonitor.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkImplicitFunctionFit);

//------------------------------------------------------------------------------
int vtkImplicitFunctionFit::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0], 0);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  return recon::RunCore(this, input, "constraint points as poly data: connect Implicit Constraints",
    { output },
    [&]
    {
      vtkContourMonitor fitting(this);
      const recon::ImplicitFunction function = recon::FitImplicitFunction(recon::PointsOf(input),
        recon::NumbersOf(input, "Value"), recon::FunctionOptionsOf(this), fitting);
      recon::ToPolyData(function, output);
      recon::FinishOutput(input, recon::JoinReports(input, function.Report), output);
    });
}

//------------------------------------------------------------------------------
void vtkImplicitFunctionFit::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Kernel: " << this->Kernel << "\n";
  os << indent << "SupportRadius: " << this->SupportRadius << "\n";
  os << indent << "Solver: " << this->Solver << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "CentreReduction: " << this->CentreReduction << "\n";
  os << indent << "Smoothing: " << this->Smoothing << "\n";
  os << indent << "Threads: " << this->Threads << "\n";
}
