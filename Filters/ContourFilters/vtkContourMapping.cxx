// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkContourMapping.h"

#include "ContourConversion.h"
#include "Contours/ContourMapping.h"
#include "FieldArrays.h"
#include "JoinTable.h"
#include "Polyhedral/ContractMapping.h"
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

void FillOutputs(const recon::ContourSet& set, const recon::ContractMapping& mapped,
  vtkPolyData* input, vtkPolyData* output, vtkTable* joins)
{
  const recon::ContourMapping& mapping = mapped.Mapping;
  recon::ToPolyData(set, output);
  AddGroups(mapping, set.Contours.size(), output);
  recon::WriteMapping(mapping, output);
  recon::PassCellData(set, input, output);
  std::vector<std::string> report = set.Report;
  report.insert(report.end(), mapping.Report.begin(), mapping.Report.end());
  recon::FinishOutput(input, report, output);
  recon::WriteJoins(mapped.WithCuts, joins);
}
}

vtkContourMapping::vtkContourMapping()
{
  this->SetNumberOfOutputPorts(2);
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
      const recon::ContourMappingOptions options = this->GetMappingOptions(overrides);
      vtkContourMonitor cleaning(this, 0.0, 0.3);
      const recon::ContourSet set = this->ReadContours(input, true, cleaning);
      vtkContourMonitor mapping(this, 0.3, 1.0);
      FillOutputs(set,
        recon::MapByContract(set, options,
          static_cast<recon::LevelAlignmentMode>(this->GetAlignLevels()),
          { this->GetExpectedPieces(), this->GetExpectedHandles() }, mapping),
        input, output, joins);
    });
}
