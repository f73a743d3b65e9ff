// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkImplicitPolygonizer.h"

#include "ContourConversion.h"
#include "ImplicitData.h"
#include "ImplicitOptions.h"
#include "RunCore.h"
#include "SurfaceSummaries.h"
#include "vtkContourMonitor.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkImplicitPolygonizer);

//------------------------------------------------------------------------------
int vtkImplicitPolygonizer::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0], 0);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  return recon::RunCore(this, input, recon::NeedsModel, { output },
    [&]
    {
      const recon::ImplicitFunction function = recon::ToFunction(input);
      vtkContourMonitor meshing(this);
      const recon::ImplicitMesh mesh = recon::Polygonize(
        function, recon::SeedsOf(function), recon::PolygonizerOptionsOf(this), meshing);
      recon::ToPolyData(mesh, output);
      recon::AddSummary(mesh.Mesh, input, output);
      recon::FinishOutput(input, recon::JoinReports(input, mesh.Report), output);
    });
}

//------------------------------------------------------------------------------
void vtkImplicitPolygonizer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Detail: " << this->Detail << "\n";
  os << indent << "CellSize: " << this->CellSize << "\n";
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
  os << indent << "Threads: " << this->Threads << "\n";
}
