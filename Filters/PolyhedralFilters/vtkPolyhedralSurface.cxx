// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPolyhedralSurface.h"

#include "ContourConversion.h"
#include "FieldArrays.h"
#include "Polyhedral/PolyhedralSurface.h"
#include "RunCore.h"
#include "vtkContourMonitor.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkPolyhedralSurface);

namespace
{
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
      const recon::ContourSet contours = this->ReadContours(input, true, cleaning);
      vtkContourMonitor building(this, 0.1, 1.0);
      const recon::PolyhedralSurface surface = recon::BuildPolyhedralSurface(
        contours, this->GetOptions(vtkTable::GetData(inputVector[1], 0)), building);
      FillOutput(contours, surface, output);
      std::vector<std::string> report = contours.Report;
      report.insert(report.end(), surface.Report.begin(), surface.Report.end());
      recon::FinishOutput(input, report, output);
    });
}

//------------------------------------------------------------------------------
void vtkPolyhedralSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
