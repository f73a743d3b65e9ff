// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFairSurface.h"

#include "ContourConversion.h"
#include "Fair/FairSurface.h"
#include "FieldArrays.h"
#include "RunCore.h"
#include "SurfaceSummaries.h"
#include "vtkContourMonitor.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkFairSurface);

namespace
{
/// Where a larger part of the contours is left out, a line in Report is not enough.
constexpr double WarnBeyond = 0.1;

void FillFairOutput(
  const recon::ContourSet& contours, const recon::FairSurface& surface, vtkPolyData* output)
{
  recon::ToPolyData(surface.Mesh, output);
  recon::AddLevels(contours, output);
  vtkFieldData* figures = output->GetFieldData();
  recon::AddValue(figures, "ContourCount", contours.Contours.size());
  recon::AddValue(figures, "LeftOutCount", surface.LeftOut);
  recon::AddValue(figures, "EndCapVolume", surface.EndCapVolume);
  recon::AddValue(figures, "IsolatedVolume", surface.IsolatedVolume);
  recon::AddValue(figures, "Tolerance", surface.Tolerance);
  recon::AddValue(figures, "EdgeLength", surface.EdgeLength);
  recon::AddValue(figures, "Tension", surface.Tension);
  recon::AddValue(figures, "FarthestVertex", surface.Farthest);
  recon::AddValue(figures, "BeyondTolerance", surface.Beyond);
  recon::AddValue(figures, "ThinTriangles", surface.Thin);
  recon::AddValue(figures, "HeldBackPoints", surface.HeldBack);
}
}

//------------------------------------------------------------------------------
int vtkFairSurface::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0], 0);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkTable* overrides = vtkTable::GetData(inputVector[1], 0);
  return recon::RunCore(this, input, recon::NeedsContours, { output },
    [&]
    {
      vtkContourMonitor cleaning(this, 0.0, 0.1);
      const recon::ContourSet contours = this->ReadContoursOfSolid(input, true, cleaning);
      std::vector<std::string> report = contours.Report;
      recon::FairOptions options;
      options.Polyhedral = this->GetOptions(input, contours, overrides, report);
      options.Polyhedral.PinchGap = recon::FairPinchGap;
      options.Tolerance = this->Tolerance;
      options.EdgeLength = this->EdgeLength;
      options.Tension = this->Tension;
      options.Threads = options.Polyhedral.Threads;
      vtkContourMonitor building(this, 0.1, 1.0);
      const recon::FairSurface surface = recon::BuildFairSurface(contours, options, building);
      report.insert(report.end(), surface.Report.begin(), surface.Report.end());
      if (surface.Mesh.Triangles.empty())
      {
        throw recon::Error("No surface came out: " +
          (report.empty() ? std::string("no contour has a partner.") : report.back()));
      }
      FillFairOutput(contours, surface, output);
      if (surface.LeftOut > WarnBeyond * contours.Contours.size())
      {
        vtkWarningMacro(<< surface.LeftOut << " of " << contours.Contours.size()
                        << " contours are left out of the surface: its Report says why.");
      }
      recon::AddSummary(surface.Mesh, input, output);
      recon::FinishOutput(input, report, output);
    });
}

//------------------------------------------------------------------------------
void vtkFairSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << '\n'
     << indent << "EdgeLength: " << this->EdgeLength << '\n'
     << indent << "Tension: " << this->Tension << '\n';
}
