// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkImplicitFunctionFit.h"

#include "ImplicitData.h"
#include "ImplicitOptions.h"
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
  if (!input || !output)
  {
    vtkErrorMacro(
      "Implicit Function needs constraint points as poly data: connect Implicit Constraints.");
    return 0;
  }
  if (recon::PassEmpty(input, output))
  {
    return 1;
  }
  try
  {
    vtkContourMonitor fitting(this);
    const recon::ImplicitFunction function = recon::FitImplicitFunction(recon::PointsOf(input),
      recon::NumbersOf(input, "Value"), recon::FunctionOptionsOf(this), fitting);
    recon::ToPolyData(function, output);
    recon::PassReport(input, function.Report, output);
  }
  catch (const recon::Aborted&)
  {
    output->Initialize();
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro("" << error.what());
    return 0;
  }
  return 1;
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
