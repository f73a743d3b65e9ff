// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkContourMapping.h"

#include "ContourConversion.h"
#include "Contours/ContourMapping.h"
#include "Contours/ContourSetBuilder.h"
#include "InputArrays.h"
#include "JoinTable.h"
#include "vtkContourMonitor.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkContourMapping);

namespace
{
void AddGroups(const recon::ContourMapping& mapping, std::size_t contours, vtkPolyData* output)
{
  vtkNew<vtkIntArray> below;
  below->SetName("MappingGroupBelow");
  vtkNew<vtkIntArray> above;
  above->SetName("MappingGroupAbove");
  for (auto* array : { below.Get(), above.Get() })
  {
    array->SetNumberOfValues(static_cast<vtkIdType>(contours));
    array->FillValue(-1);
    output->GetCellData()->AddArray(array);
  }
  for (std::size_t g = 0; g < mapping.Groups.size(); ++g)
  {
    for (int c : mapping.Groups[g].LowerContours)
    {
      above->SetValue(c, static_cast<int>(g));
    }
    for (int c : mapping.Groups[g].UpperContours)
    {
      below->SetValue(c, static_cast<int>(g));
    }
  }
}
}

vtkContourMapping::vtkContourMapping()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

void vtkContourMapping::SetOverridesConnection(vtkAlgorithmOutput* overrides)
{
  this->SetInputConnection(1, overrides);
}

void vtkContourMapping::AddForcedJoin(int contour, int otherContour)
{
  this->ForcedJoins.emplace_back(contour, otherContour);
  this->Modified();
}

void vtkContourMapping::RemoveAllForcedJoins()
{
  this->ForcedJoins.clear();
  this->Modified();
}

void vtkContourMapping::AddForbiddenJoin(int contour, int otherContour)
{
  this->ForbiddenJoins.emplace_back(contour, otherContour);
  this->Modified();
}

void vtkContourMapping::RemoveAllForbiddenJoins()
{
  this->ForbiddenJoins.clear();
  this->Modified();
}

int vtkContourMapping::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkContourMapping::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

int vtkContourMapping::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkTable* overrides = vtkTable::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkTable* joins = vtkTable::GetData(outputVector, 1);
  if (!input || !output || !joins)
  {
    vtkErrorMacro("Contour Mapping needs contours as poly data: connect Contour Hierarchy.");
    return 0;
  }
  if (input->GetNumberOfCells() == 0)
  {
    recon::PassInputFieldData(input, output);
    recon::WriteJoins({}, joins);
    return 1;
  }
  if (recon::PassPoints(this, input, output))
  {
    recon::WriteJoins({}, joins);
    return 1;
  }
  try
  {
    recon::ContourMappingOptions options;
    options.OverlapThreshold = this->OverlapThreshold;
    options.MaximumGap = this->MaximumGap;
    options.ForcedJoins = this->ForcedJoins;
    options.ForbiddenJoins = this->ForbiddenJoins;
    options.Threads = this->Threads;
    if (overrides)
    {
      recon::ReadJoinOverrides(overrides, options);
    }
    const recon::ConvertedLoops loops = recon::ToLoopSoup(input);
    vtkContourMonitor cleaning(this, 0.0, 0.3);
    const recon::ContourSet set =
      recon::BuildContourSet(loops.Soup, recon::ContourSetOptions(), cleaning);
    vtkContourMonitor monitor(this, 0.3, 1.0);
    const recon::ContourMapping mapping = recon::BuildContourMapping(set, options, monitor);

    std::vector<std::string> report = recon::GetReport(input);
    report.insert(report.end(), loops.Report.begin(), loops.Report.end());
    recon::ToPolyData(set, report, output);
    report = recon::GetReport(output);
    report.insert(report.end(), mapping.Report.begin(), mapping.Report.end());
    recon::SetReport(report, output);
    AddGroups(mapping, set.Contours.size(), output);
    recon::PassCellData(set, input, output);
    recon::PassInputFieldData(input, output);
    recon::WriteJoins(mapping, joins);
    return 1;
  }
  catch (const recon::Aborted&)
  {
    output->Initialize();
    joins->Initialize();
    return 1;
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    joins->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
}

void vtkContourMapping::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OverlapThreshold: " << this->OverlapThreshold << endl;
  os << indent << "MaximumGap: " << this->MaximumGap << endl;
  os << indent << "Threads: " << this->Threads << endl;
  const auto print = [&](const char* name, const std::vector<std::pair<int, int>>& pairs)
  {
    os << indent << name << ":";
    for (const auto& pair : pairs)
    {
      os << " (" << pair.first << ", " << pair.second << ")";
    }
    os << endl;
  };
  print("ForcedJoins", this->ForcedJoins);
  print("ForbiddenJoins", this->ForbiddenJoins);
}
