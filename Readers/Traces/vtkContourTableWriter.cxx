// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkContourTableWriter.h"

#include "Common/ClosedLoops.h"
#include "ContourConversion.h"
#include "FieldArrays.h"
#include "SurfaceBlocks.h"
#include "Table/ContourTableFormatter.h"
#include "vtkContourMonitor.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <utility>

vtkStandardNewMacro(vtkContourTableWriter);

namespace
{
/// Closed contours; what is chained of loose pieces has no slice of its own.
recon::LoopSoup LoopsOf(vtkPolyData* block, recon::Monitor& monitor)
{
  recon::ConvertedLoops converted = recon::ToLoopSoup(block);
  if (block->GetCellData()->HasArray("GeometricType"))
  {
    return std::move(converted.Soup);
  }
  int looseVertices = 0;
  return recon::CloseLoops(
    std::move(converted.Soup), "Tables of contours hold", looseVertices, monitor);
}

/// The number of the slice of each chain; empty where the block does not tell.
std::vector<int> SlicesOf(vtkPolyData* block, const recon::LoopSoup& soup)
{
  std::vector<int> slices;
  vtkDataArray* array = block->GetCellData()->GetArray("Slice");
  for (const recon::LoopSoup::Chain& chain : soup.Chains)
  {
    if (!array || chain.Source < 0 || chain.Source >= array->GetNumberOfTuples())
    {
      return {};
    }
    slices.push_back(static_cast<int>(array->GetTuple1(chain.Source)));
  }
  return slices;
}

std::string NameOf(const recon::NamedPolyData& block)
{
  const std::string told = recon::FieldText(block.Data->GetFieldData(), "ROIName");
  return !block.Name.empty() ? block.Name : !told.empty() ? told : "contours";
}

/// The unit that a block tells; that of DICOM is the millimetre.
std::string UnitOf(vtkPolyData* block)
{
  const std::string told = recon::FieldText(block->GetFieldData(), "LengthUnit");
  const bool isDICOM = told.empty() && block->GetFieldData()->HasArray("FrameOfReferenceUID");
  return isDICOM ? "mm" : told;
}

recon::TracedFile ToTracedFile(vtkDataObject* input, recon::Monitor& monitor)
{
  recon::TracedFile file;
  bool isFirst = true;
  for (const recon::NamedPolyData& block : recon::ListPolyData(input))
  {
    if (block.Data->GetNumberOfCells() == 0)
    {
      continue;
    }
    recon::TracedObject object;
    object.Name = NameOf(block);
    object.Soup = LoopsOf(block.Data, monitor);
    object.Slices = SlicesOf(block.Data, object.Soup);
    file.Objects.push_back(std::move(object));
    const std::string unit = UnitOf(block.Data);
    file.LengthUnit = isFirst || unit == file.LengthUnit ? unit : std::string();
    isFirst = false;
  }
  return file;
}
}

vtkContourTableWriter::vtkContourTableWriter() = default;

vtkContourTableWriter::~vtkContourTableWriter()
{
  this->SetFileName(nullptr);
}

void vtkContourTableWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << endl;
}

int vtkContourTableWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  return 1;
}

void vtkContourTableWriter::WriteWhole()
{
  vtkContourMonitor monitor(this);
  const recon::TracedFile file = ToTracedFile(this->GetWhole(), monitor);
  for (const std::string& line : recon::WriteContourTable(this->FileName, file, monitor))
  {
    vtkWarningMacro(<< line);
  }
}
