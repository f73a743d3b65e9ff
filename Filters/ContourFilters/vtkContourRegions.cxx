// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkContourRegions.h"

#include "Base/Monitor.h"
#include "Base/Text.h"
#include "ContourConversion.h"
#include "FieldArrays.h"
#include "Pieces.h"
#include "Ranks.h"
#include "RunCore.h"
#include "SliceBlocks.h"
#include "SurfaceBlocks.h"
#include "vtkContourAlgorithm.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#include <map>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkContourRegions);

namespace
{
using Region = std::pair<std::string, vtkSmartPointer<vtkPolyData>>;

std::vector<vtkPolyData*> AllBlocks(vtkDataObject* input)
{
  std::vector<vtkPolyData*> blocks;
  for (const recon::NamedPolyData& block : recon::ListPolyData(input))
  {
    if (block.Data->GetNumberOfCells() > 0)
    {
      blocks.push_back(block.Data);
    }
  }
  return blocks;
}

std::vector<Region> BlockRegions(vtkDataObject* input)
{
  std::vector<Region> regions;
  for (const recon::NamedPolyData& block : recon::ListPolyData(input))
  {
    const std::string number = "region " + std::to_string(regions.size() + 1);
    regions.emplace_back(block.Name.empty() ? number : block.Name, block.Data);
  }
  return regions;
}

/// Cells of an input one by one, each with the points that it needs.
class CellCopier
{
public:
  explicit CellCopier(vtkPolyData* input)
    : Input(input),
      Output(vtkSmartPointer<vtkPolyData>::New())
  {
    this->Points->SetDataType(input->GetPoints()->GetDataType());
    this->Output->AllocateEstimate(input->GetNumberOfCells(), 4);
    this->Output->GetCellData()->CopyAllocate(input->GetCellData());
    this->Output->GetPointData()->CopyAllocate(input->GetPointData());
  }

  void Copy(vtkIdType cell)
  {
    this->Input->GetCellPoints(cell, this->Ids);
    for (vtkIdType i = 0; i < this->Ids->GetNumberOfIds(); ++i)
    {
      this->Ids->SetId(i, this->NumberOf(this->Ids->GetId(i)));
    }
    const vtkIdType copied =
      this->Output->InsertNextCell(this->Input->GetCellType(cell), this->Ids);
    this->Output->GetCellData()->CopyData(this->Input->GetCellData(), cell, copied);
  }

  vtkSmartPointer<vtkPolyData> Take()
  {
    this->Output->SetPoints(this->Points);
    this->Output->GetFieldData()->ShallowCopy(this->Input->GetFieldData());
    return this->Output;
  }

private:
  vtkIdType NumberOf(vtkIdType point)
  {
    const auto [found, isNew] = this->Numbers.emplace(point, this->Points->GetNumberOfPoints());
    if (isNew)
    {
      this->Points->InsertNextPoint(this->Input->GetPoint(point));
      this->Output->GetPointData()->CopyData(this->Input->GetPointData(), point, found->second);
    }
    return found->second;
  }

  vtkPolyData* Input;
  vtkSmartPointer<vtkPolyData> Output;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkIdList> Ids;
  std::map<vtkIdType, vtkIdType> Numbers;
};

/// The values of the array in a cell, as a person would write them.
std::string ValueOf(vtkAbstractArray* array, vtkIdType cell)
{
  std::string words;
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    const vtkVariant value = array->GetVariantValue(cell * array->GetNumberOfComponents() + c);
    words += (c > 0 ? " " : "") + value.ToString();
  }
  return words.empty() ? "unnamed" : words;
}

/// Vertices are numbered before lines, and lines before polygons, in the input and in each part: so
/// their order stays, and cell data with it.
std::vector<Region> SplitRegion(const Region& region, vtkAbstractArray* array, bool isOnly)
{
  std::vector<std::string> order;
  std::map<std::string, CellCopier> parts;
  vtkPolyData* input = region.second;
  input->BuildCells();
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    const std::string value = ValueOf(array, cell);
    const auto [found, isNew] = parts.try_emplace(value, input);
    if (isNew)
    {
      order.push_back(value);
    }
    found->second.Copy(cell);
  }
  std::vector<Region> split;
  for (const std::string& value : order)
  {
    split.emplace_back(isOnly ? value : region.first + " " + value, parts.at(value).Take());
  }
  return split;
}

std::string ArrayNames(const std::vector<Region>& regions)
{
  std::vector<std::string> names;
  for (const Region& region : regions)
  {
    vtkCellData* data = region.second->GetCellData();
    for (int i = 0; i < data->GetNumberOfArrays() && names.empty(); ++i)
    {
      names.emplace_back(data->GetArrayName(i) ? data->GetArrayName(i) : "");
    }
  }
  return names.empty() ? "none" : recon::Listed(names, 10);
}

std::vector<Region> SplitRegions(
  const std::vector<Region>& regions, const char* name, std::vector<std::string>& report)
{
  std::vector<Region> split;
  std::size_t without = 0;
  for (const Region& region : regions)
  {
    vtkAbstractArray* array = region.second->GetCellData()->GetAbstractArray(name);
    without += !array;
    const std::vector<Region> parts = array && region.second->GetNumberOfCells() > 0
      ? SplitRegion(region, array, regions.size() == 1)
      : std::vector<Region>{ region };
    split.insert(split.end(), parts.begin(), parts.end());
  }
  if (without == regions.size())
  {
    throw recon::Error("There is no cell array " + std::string(name) +
      " to split the contours by; there are: " + ArrayNames(regions) + ".");
  }
  report.push_back(
    "Split by " + std::string(name) + " into " + recon::Counted(split.size(), "region") + ".");
  if (without > 0)
  {
    report.push_back(recon::Counted(without, "block") + " without " + name + ": left whole.");
  }
  return split;
}

/// The arrays of the cells without a cell: what another piece has.
void LeaveOutCells(vtkPolyData* data)
{
  vtkNew<vtkCellData> cells;
  cells->CopyAllocate(data->GetCellData());
  vtkNew<vtkPolyData> none;
  none->SetPoints(vtkNew<vtkPoints>());
  none->GetCellData()->ShallowCopy(cells);
  none->SetFieldData(data->GetFieldData());
  data->ShallowCopy(none);
}

void FillOutput(
  const std::vector<Region>& regions, recon::Piece piece, vtkPartitionedDataSetCollection* output)
{
  std::vector<std::size_t> weights;
  for (const Region& region : regions)
  {
    weights.push_back(static_cast<std::size_t>(region.second->GetNumberOfPoints()));
  }
  const recon::RegionShares shares(weights, piece);
  for (std::size_t r = 0; r < regions.size(); ++r)
  {
    const auto& [name, contours] = regions[r];
    const auto block = static_cast<unsigned int>(r);
    vtkNew<vtkPolyData> data;
    data->ShallowCopy(contours);
    vtkNew<vtkFieldData> field; // the input's own must not get the name
    field->ShallowCopy(contours->GetFieldData());
    data->SetFieldData(field);
    if (!shares.IsOwn(r))
    {
      LeaveOutCells(data);
    }
    recon::AddValue(data->GetFieldData(), "ROIName", name);
    shares.Mark(r, data);
    output->SetPartition(block, 0, data);
    output->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), name.c_str());
  }
}
}

vtkContourRegions::~vtkContourRegions()
{
  this->SetSplitBy(nullptr);
}

void vtkContourRegions::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Blocks: " << this->Blocks << endl;
  os << indent << "SplitBy: " << (this->SplitBy ? this->SplitBy : "(none)") << endl;
}

const char* vtkContourRegions::GetReport()
{
  this->ReportText = vtkContourAlgorithm::ReportOf(this);
  return this->ReportText.c_str();
}

int vtkContourRegions::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkContourRegions::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* output = vtkPartitionedDataSetCollection::GetData(outputVector);
  return recon::RunOnAnything(this, { output },
    [&]
    {
      // What the regions are follows from all of them, so every rank looks at all and keeps its own.
      const auto brought =
        recon::Ranks(inputVector[0])
          .BringToAll(vtkDataObject::GetData(inputVector[0]), recon::SpreadBlocks::Append);
      vtkDataObject* input = brought;
      std::vector<std::string> report = recon::GetReport(input);
      std::vector<Region> regions = BlockRegions(input);
      const bool isCollection = !vtkPolyData::SafeDownCast(input);
      std::vector<vtkPolyData*> slices;
      if (isCollection && this->Blocks != Regions)
      {
        slices = this->Blocks == Slices ? AllBlocks(input) : recon::FindSliceBlocks(input);
      }
      if (!slices.empty())
      {
        regions = { { "object", recon::JoinBlocks(slices) } };
        report.push_back(
          recon::Counted(slices.size(), "block") + " taken as slices of one object.");
      }
      else if (isCollection)
      {
        report.push_back(recon::Counted(regions.size(), "block") + " taken as a region each.");
      }
      if (this->SplitBy && *this->SplitBy && !regions.empty())
      {
        regions = SplitRegions(regions, this->SplitBy, report);
      }
      FillOutput(regions, recon::RequestedPiece(outputVector), output);
      recon::SetReport(report, output);
    });
}
