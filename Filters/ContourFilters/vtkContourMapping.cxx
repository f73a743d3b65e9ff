// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkContourMapping.h"

#include "ContourConversion.h"
#include "Contours/ContourMapping.h"
#include "Contours/LevelAlignment.h"
#include "FieldArrays.h"
#include "JoinTable.h"
#include "RunCore.h"
#include "vtkContourMonitor.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkContourMapping);

namespace
{
void AddGroups(const recon::ContourMapping& mapping, std::size_t contours, vtkPolyData* output)
{
  std::vector<int> below(contours, -1);
  std::vector<int> above(contours, -1);
  int number = 0;
  for (const recon::MappingGroup& group : mapping.Groups)
  {
    for (const int c : group.LowerContours)
    {
      above[c] = number;
    }
    for (const int c : group.UpperContours)
    {
      below[c] = number;
    }
    ++number;
  }
  recon::AddArray(output->GetCellData(), "MappingGroupBelow", below);
  recon::AddArray(output->GetCellData(), "MappingGroupAbove", above);
}

void FillOutputs(const recon::ContourSet& set, const recon::ContourMapping& mapping,
  vtkPolyData* input, vtkPolyData* output, vtkTable* joins)
{
  recon::ToPolyData(set, output);
  AddGroups(mapping, set.Contours.size(), output);
  recon::WriteMapping(mapping, output);
  recon::PassCellData(set, input, output);
  std::vector<std::string> report = set.Report;
  report.insert(report.end(), mapping.Report.begin(), mapping.Report.end());
  recon::FinishOutput(input, report, output);
  recon::WriteJoins(mapping, joins);
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
  recon::WriteJoins({}, joins); // an empty table has its columns
  return recon::RunCore(this, input, recon::NeedsContours, { output, joins },
    [&]
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
      vtkContourMonitor cleaning(this, 0.0, 0.3);
      const recon::ContourSet set = this->ReadContours(input, true, cleaning);
      vtkContourMonitor mapping(this, 0.3, 1.0);
      // As Polyhedral Surface does, so that both come to the same decisions.
      const recon::LevelAlignment alignment = recon::FindLevelAlignment(
        set, static_cast<recon::LevelAlignmentMode>(this->AlignLevels), options.ForcedJoins);
      recon::ContourMapping mapped =
        recon::BuildContourMapping(recon::Aligned(set, alignment), options, mapping);
      mapped.Report.insert(mapped.Report.begin(), alignment.Report.begin(), alignment.Report.end());
      FillOutputs(set, mapped, input, output, joins);
    });
}

void vtkContourMapping::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OverlapThreshold: " << this->OverlapThreshold << endl;
  os << indent << "MaximumGap: " << this->MaximumGap << endl;
  os << indent << "AlignLevels: " << this->AlignLevels << endl;
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
