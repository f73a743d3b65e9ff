// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkImplicitPolygonizer.h"

#include "ImplicitData.h"
#include "ImplicitOptions.h"
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
  if (!input || !output)
  {
    vtkErrorMacro("Implicit Polygonizer needs a model as poly data: connect Implicit Function.");
    return 0;
  }
  if (recon::PassEmpty(input, output))
  {
    return 1;
  }
  try
  {
    const recon::ImplicitFunction function = recon::ToFunction(input);
    vtkContourMonitor meshing(this);
    const recon::ImplicitMesh mesh = recon::Polygonize(
      function, recon::SeedsOf(function), recon::PolygonizerOptionsOf(this), meshing);
    recon::ToPolyData(mesh, output);
    recon::PassReport(input, mesh.Report, output);
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
