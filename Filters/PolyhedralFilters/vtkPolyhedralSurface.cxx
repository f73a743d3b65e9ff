// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPolyhedralSurface.h"

#include "JoinTable.h"
#include "Polyhedral/PolyhedralSurface.h"
#include "PolyhedralInput.h"
#include "vtkContourMonitor.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkPolyhedralSurface);

namespace
{
void AddDouble(vtkFieldData* data, const char* name, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  data->AddArray(array);
}

void AddStages(const std::vector<std::pair<std::string, double>>& stages, vtkFieldData* data)
{
  vtkNew<vtkStringArray> names;
  names->SetName("StageName");
  vtkNew<vtkDoubleArray> seconds;
  seconds->SetName("StageSeconds");
  for (const auto& stage : stages)
  {
    names->InsertNextValue(stage.first);
    seconds->InsertNextValue(stage.second);
  }
  data->AddArray(names);
  data->AddArray(seconds);
}

void FillOutput(vtkPolyData* input, const recon::ContourSet& contours,
  const recon::PolyhedralSurface& surface, vtkPolyData* output)
{
  recon::ToPolyData(surface.Mesh, output);
  recon::PassFieldData(input, output);
  recon::AddIntArray(output->GetCellData(), "Slab", surface.Slab);
  recon::AddIntArray(output->GetCellData(), "FaceKind", surface.FaceKind);
  recon::AddIntArray(output->GetCellData(), "MappingGroup", surface.MappingGroup);
  recon::AddIntArray(output->GetPointData(), "PointKind", surface.PointKind);
  recon::AddLevels(contours, output->GetFieldData());
  recon::AddIntArray(
    output->GetFieldData(), "ContourCount", std::vector<std::size_t>{ contours.Contours.size() });
  AddDouble(output->GetFieldData(), "EndCapVolume", surface.EndCapVolume);
  AddDouble(output->GetFieldData(), "IsolatedVolume", surface.IsolatedVolume);
  AddStages(surface.StageSeconds, output->GetFieldData());
  std::vector<std::string> report = contours.Report;
  report.insert(report.end(), surface.Report.begin(), surface.Report.end());
  recon::SetReport(report, output);
}
}

//------------------------------------------------------------------------------
vtkPolyhedralSurface::vtkPolyhedralSurface()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
void vtkPolyhedralSurface::SetOverridesConnection(vtkAlgorithmOutput* overrides)
{
  this->SetInputConnection(1, overrides);
}

//------------------------------------------------------------------------------
int vtkPolyhedralSurface::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
void vtkPolyhedralSurface::AddForcedJoin(int contour, int otherContour)
{
  this->ForcedJoins.emplace_back(contour, otherContour);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPolyhedralSurface::RemoveAllForcedJoins()
{
  this->ForcedJoins.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPolyhedralSurface::AddForbiddenJoin(int contour, int otherContour)
{
  this->ForbiddenJoins.emplace_back(contour, otherContour);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPolyhedralSurface::RemoveAllForbiddenJoins()
{
  this->ForbiddenJoins.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkPolyhedralSurface::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0], 0);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  if (!input || !output)
  {
    vtkErrorMacro(
      "Polyhedral Surface needs contours as poly data: connect a contour reader or Slice.");
    return 0;
  }
  if (recon::PassEmptyInput(input, output) || recon::PassPoints(this, input, output))
  {
    return 1;
  }
  try
  {
    vtkContourMonitor cleaning(this, 0.0, 0.1);
    const recon::ContourSet contours = recon::ReadParallelContours(input, cleaning);

    recon::PolyhedralOptions options;
    options.InternalPoints = this->InternalPoints;
    options.LiftInternalPoints = this->LiftInternalPoints;
    options.Mapping = static_cast<recon::PolyhedralOptions::MappingType>(this->Mapping);
    options.OverlapThreshold = this->OverlapThreshold;
    recon::ContourMappingOptions overrides;
    overrides.ForcedJoins = this->ForcedJoins;
    overrides.ForbiddenJoins = this->ForbiddenJoins;
    if (vtkTable* table = vtkTable::GetData(inputVector[1], 0))
    {
      recon::ReadJoinOverrides(table, overrides);
    }
    options.ForcedJoins = overrides.ForcedJoins;
    options.ForbiddenJoins = overrides.ForbiddenJoins;
    options.MaximumGap = this->MaximumGap;
    options.EndCaps = static_cast<recon::PolyhedralOptions::EndCapsType>(this->EndCaps);
    options.IsolatedContours =
      static_cast<recon::PolyhedralOptions::IsolatedContoursType>(this->IsolatedContours);
    options.Threads = this->Threads;
    vtkContourMonitor building(this, 0.1, 1.0);
    FillOutput(input, contours, recon::BuildPolyhedralSurface(contours, options, building), output);
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
void vtkPolyhedralSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InternalPoints: " << this->InternalPoints << '\n'
     << indent << "LiftInternalPoints: " << this->LiftInternalPoints << '\n'
     << indent << "Mapping: " << this->Mapping << '\n'
     << indent << "OverlapThreshold: " << this->OverlapThreshold << '\n'
     << indent << "ForcedJoins: " << this->ForcedJoins.size() << '\n'
     << indent << "ForbiddenJoins: " << this->ForbiddenJoins.size() << '\n'
     << indent << "MaximumGap: " << this->MaximumGap << '\n'
     << indent << "EndCaps: " << this->EndCaps << '\n'
     << indent << "IsolatedContours: " << this->IsolatedContours << '\n'
     << indent << "Threads: " << this->Threads << '\n';
}
