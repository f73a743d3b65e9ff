// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkImplicitSurface.h"

#include "FieldArrays.h"
#include "Implicit/ImplicitSurface.h"
#include "ImplicitData.h"
#include "ImplicitOptions.h"
#include "RunCore.h"
#include "SurfaceSummaries.h"
#include "vtkContourMonitor.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkImplicitSurface);

namespace
{
recon::ImplicitSurfaceOptions OptionsOf(vtkImplicitSurface* filter)
{
  recon::ImplicitSurfaceOptions options;
  options.Constraints = recon::ConstraintOptionsOf(filter);
  options.Function = recon::FunctionOptionsOf(filter);
  options.Polygonizer = recon::PolygonizerOptionsOf(filter);
  options.EndsBeyond = filter->GetEndsBeyond();
  return options;
}
}

//------------------------------------------------------------------------------
int vtkImplicitSurface::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0], 0);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  return recon::RunCore(this, input, recon::NeedsContours, { output },
    [&]
    {
      vtkContourMonitor cleaning(this, 0.0, 0.05);
      const recon::ContourSet contours = this->ReadContoursOfSolid(input, false, cleaning);
      vtkContourMonitor building(this, 0.05, 1.0);
      const recon::ImplicitSurface surface =
        recon::BuildImplicitSurface(contours, OptionsOf(this), building);
      recon::ToPolyData(surface.Mesh, output);
      vtkFieldData* figures = output->GetFieldData();
      recon::AddValue(figures, "Residual", surface.Fit.Function.Residual);
      recon::AddValue(figures, "MarginDistance", surface.Fit.Constraints.MarginDistance);
      recon::AddValue(
        figures, "ConstraintCount", static_cast<double>(surface.Fit.Function.Centres.size()));
      recon::AddSummary(surface.Mesh.Mesh, input, output);
      recon::FinishOutput(input, surface.Report, output);
    });
}

//------------------------------------------------------------------------------
void vtkImplicitSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Detail: " << this->Detail << "\n";
  os << indent << "Kernel: " << this->Kernel << "\n";
  os << indent << "SupportRadius: " << this->SupportRadius << "\n";
  os << indent << "Solver: " << this->Solver << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "CentreReduction: " << this->CentreReduction << "\n";
  os << indent << "Smoothing: " << this->Smoothing << "\n";
  os << indent << "CellSize: " << this->CellSize << "\n";
  os << indent << "EndsBeyond: " << this->EndsBeyond << "\n";
  os << indent << "UseBounds: " << this->UseBounds << "\n";
  os << indent << "Bounds:";
  for (const double x : this->Bounds)
  {
    os << " " << x;
  }
  os << "\n";
  os << indent << "ClosedAtBounds: " << this->ClosedAtBounds << "\n";
  os << indent << "CleanUp: " << this->CleanUp << "\n";
  os << indent << "SnapToContours: " << this->SnapToContours << "\n";
  os << indent << "MaximumCells: " << this->MaximumCells << "\n";
}
