// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPolyhedralSurface.h"

#include "ContourConversion.h"
#include "FieldArrays.h"
#include "Polyhedral/KeptStages.h"
#include "Polyhedral/LeftOut.h"
#include "Polyhedral/PolyhedralSurface.h"
#include "RunCore.h"
#include "SurfaceSummaries.h"
#include "vtkContourMonitor.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkPolyhedralSurface);

vtkPolyhedralSurface::vtkPolyhedralSurface() : Kept(std::make_unique<recon::KeptStages>()) {}

vtkPolyhedralSurface::~vtkPolyhedralSurface() = default;

namespace
{
/// Where a larger part of the contours is left out, a line in Report is not enough.
constexpr double WarnBeyond = 0.1;

void AddStages(const std::vector<std::pair<std::string, double>>& stages, vtkFieldData* data)
{
  std::vector<std::string> names;
  std::vector<double> seconds;
  for (const auto& stage : stages)
  {
    names.push_back(stage.first);
    seconds.push_back(stage.second);
  }
  recon::AddArray(data, "StageName", names);
  recon::AddArray(data, "StageSeconds", seconds);
}

void FillOutput(
  const recon::ContourSet& contours, const recon::PolyhedralSurface& surface, vtkPolyData* output)
{
  recon::ToPolyData(surface.Mesh, output);
  recon::AddArray(output->GetCellData(), "Slab", surface.Slab);
  recon::AddArray(output->GetCellData(), "FaceKind", surface.FaceKind);
  recon::AddArray(output->GetCellData(), "MappingGroup", surface.MappingGroup);
  recon::AddArray(output->GetCellData(), "Piece", surface.Piece);
  recon::AddArray(output->GetPointData(), "PointKind", surface.PointKind);
  recon::AddLevels(contours, output);
  vtkFieldData* figures = output->GetFieldData();
  recon::AddValue(figures, "ContourCount", contours.Contours.size());
  recon::AddValue(figures, "EndCapVolume", surface.EndCapVolume);
  recon::AddValue(figures, "IsolatedVolume", surface.IsolatedVolume);
  AddStages(surface.StageSeconds, figures);
}
}

//------------------------------------------------------------------------------
int vtkPolyhedralSurface::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0], 0);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  return recon::RunCore(this, input, recon::NeedsContours, { output },
    [&]
    {
      vtkContourMonitor cleaning(this, 0.0, 0.1);
      const recon::ContourSet contours = this->ReadContoursOfSolid(input, true, cleaning);
      std::vector<std::string> report = contours.Report;
      recon::PolyhedralOptions options =
        this->GetOptions(input, contours, vtkTable::GetData(inputVector[1], 0), report);
      options.PinchGap = this->PinchGap;
      vtkContourMonitor building(this, 0.1, 1.0);
      const recon::PolyhedralSurface surface = recon::BuildPolyhedralSurface(
        contours, options, building, recon::TetrahedraWanted::ForSurface, this->Kept.get());
      report.insert(report.end(), surface.Report.begin(), surface.Report.end());
      recon::CheckNotEmpty(surface.Mesh, report);
      FillOutput(contours, surface, output);
      const std::size_t leftOut = recon::CountLeftOut(contours, surface.Mesh);
      recon::AddValue(output->GetFieldData(), "LeftOutCount", leftOut);
      if (leftOut > WarnBeyond * contours.Contours.size())
      {
        vtkWarningMacro(<< leftOut << " of " << contours.Contours.size()
                        << " contours are left out of the surface: its Report says why.");
      }
      recon::AddSummary(surface.Mesh, input, output);
      recon::FinishOutput(input, report, output);
    });
}

//------------------------------------------------------------------------------
void vtkPolyhedralSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PinchGap: " << this->PinchGap << '\n';
}
