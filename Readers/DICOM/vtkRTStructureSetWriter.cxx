// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkRTStructureSetWriter.h"

#include "ContourConversion.h"
#include "DICOM/ROIContours.h"
#include "DICOM/StructureSetFormatter.h"
#include "FieldArrays.h"
#include "vtkContourMonitor.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <set>
#include <utility>

vtkStandardNewMacro(vtkRTStructureSetWriter);

namespace
{
/// The data of an ROI: a block, whatever number of pieces it comes in.
struct Block
{
  std::string Name;
  std::vector<vtkPolyData*> Pieces;
};

std::string TextOrEmpty(const char* text)
{
  return text ? text : "";
}

std::string NameIn(vtkInformation* metaData)
{
  return metaData && metaData->Has(vtkCompositeDataSet::NAME())
    ? TextOrEmpty(metaData->Get(vtkCompositeDataSet::NAME()))
    : std::string();
}

void AddPiece(vtkDataObject* data, Block& block)
{
  if (!data)
  {
    return;
  }
  auto* piece = vtkPolyData::SafeDownCast(data);
  if (!piece)
  {
    throw recon::Error("Block \"" + block.Name + "\" is a " + data->GetClassName() +
      ", and contours are poly data: pick the blocks with contours by Extract Block.");
  }
  block.Pieces.push_back(piece);
}

std::vector<Block> BlocksOf(vtkPartitionedDataSetCollection* collection)
{
  std::vector<Block> blocks;
  for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
  {
    Block block{ collection->HasMetaData(i) ? NameIn(collection->GetMetaData(i)) : std::string(),
      {} };
    for (unsigned int k = 0; k < collection->GetNumberOfPartitions(i); ++k)
    {
      AddPiece(collection->GetPartitionAsDataObject(i, k), block);
    }
    blocks.push_back(std::move(block));
  }
  return blocks;
}

std::vector<Block> BlocksOf(vtkDataObject* input)
{
  if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(input))
  {
    return BlocksOf(collection);
  }
  std::vector<Block> blocks;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    const auto leaf = vtk::TakeSmartPointer(composite->NewIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      Block block{ leaf->HasCurrentMetaData() ? NameIn(leaf->GetCurrentMetaData()) : std::string(),
        {} };
      AddPiece(leaf->GetCurrentDataObject(), block);
      blocks.push_back(std::move(block));
    }
    return blocks;
  }
  if (!input)
  {
    throw recon::Error("There are no contours to write: connect contours to the writer.");
  }
  blocks.emplace_back();
  AddPiece(input, blocks.back());
  return blocks;
}

/// Whether two polygons have an edge in common, as contours do not.
bool IsSurface(vtkPolyData* data)
{
  std::set<std::pair<vtkIdType, vtkIdType>> edges;
  const auto cell = vtk::TakeSmartPointer(data->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(count, ids);
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (!edges.insert(std::minmax(ids[i], ids[(i + 1) % count])).second)
      {
        return true;
      }
    }
  }
  return false;
}

/// The lines and points of poly data, and what the cell array GeometricType says of them.
recon::ROIPiece PieceOf(vtkPolyData* data)
{
  recon::ConvertedLoops converted = recon::ToLoopSoup(data);
  recon::ROIPiece piece;
  piece.Soup = std::move(converted.Soup);
  piece.Report = std::move(converted.Report);
  piece.OnlyVertices = data->GetNumberOfCells() == data->GetNumberOfVerts();
  auto* types =
    vtkStringArray::SafeDownCast(data->GetCellData()->GetAbstractArray("GeometricType"));
  for (vtkIdType i = 0; types && i < types->GetNumberOfValues(); ++i)
  {
    piece.GeometricTypes.push_back(types->GetValue(i));
  }
  return piece;
}

void Collect(vtkPolyData* data, recon::ROIContours& contours, recon::WrittenROI& roi)
{
  if (data->GetNumberOfCells() == 0)
  {
    return;
  }
  if (IsSurface(data))
  {
    throw recon::Error("ROI \"" + roi.Description.Name +
      "\" is a surface, and a structure set holds contours: cut it by "
      "Slice, or take Implicit Contours on the planes of the images.");
  }
  contours.Collect(PieceOf(data), roi);
}

/// What the reader says about an ROI, from the first piece of the block.
recon::StructureSetROI DescriptionOf(const Block& block)
{
  recon::StructureSetROI roi;
  if (!block.Pieces.empty())
  {
    vtkPolyData* data = block.Pieces.front();
    roi.Name = recon::FieldText(data->GetFieldData(), "ROIName");
    roi.Type = recon::FieldText(data->GetFieldData(), "ROIType");
    roi.FrameOfReferenceUID = recon::FieldText(data->GetFieldData(), "FrameOfReferenceUID");
    vtkDataArray* number = data->GetFieldData()->GetArray("ROINumber");
    roi.Number =
      number && number->GetNumberOfTuples() == 1 ? static_cast<int>(number->GetComponent(0, 0)) : 0;
    vtkDataArray* color = data->GetFieldData()->GetArray("ROIColor");
    if (color && color->GetNumberOfComponents() == 3 && color->GetNumberOfTuples() == 1)
    {
      roi.HasColor = true;
      for (int c = 0; c < 3; ++c)
      {
        roi.Color[c] = static_cast<int>(std::clamp(color->GetComponent(0, c), 0.0, 255.0));
      }
    }
  }
  if (roi.Name.empty())
  {
    roi.Name = block.Name.empty() ? "Contours" : block.Name;
  }
  return roi;
}

recon::StructureSetOptions OptionsOf(vtkRTStructureSetWriter* writer)
{
  static const char* const algorithms[] = { "AUTOMATIC", "SEMIAUTOMATIC", "MANUAL" };
  recon::StructureSetOptions options;
  options.Reference = TextOrEmpty(writer->GetReferenceFileName());
  options.CopyReferenceROIs = writer->GetCopyReferenceROIs();
  options.Label = TextOrEmpty(writer->GetStructureSetLabel());
  options.GenerationAlgorithm = algorithms[writer->GetGenerationAlgorithm()];
  options.ExclusiveOr = writer->GetHoles() == vtkRTStructureSetWriter::ExclusiveOr;
  return options;
}

std::vector<recon::WrittenROI> ROIsOf(vtkRTStructureSetWriter* writer, vtkDataObject* input,
  std::vector<std::string>& report, recon::Monitor& monitor)
{
  const std::string name = TextOrEmpty(writer->GetROIName());
  const std::string type = TextOrEmpty(writer->GetROIType());
  const std::vector<Block> blocks = BlocksOf(input);
  if (!name.empty() && blocks.size() > 1)
  {
    throw recon::Error("ROIName names one ROI, and the input has " + std::to_string(blocks.size()) +
      " blocks: pick one by Extract Block, or leave it empty.");
  }
  const bool keyholes = writer->GetHoles() == vtkRTStructureSetWriter::Keyholes;
  recon::ROIContours contours(keyholes, report, monitor);
  std::vector<recon::WrittenROI> rois;
  for (const Block& block : blocks)
  {
    recon::WrittenROI roi{ DescriptionOf(block), {} };
    roi.Description.Name = name.empty() ? roi.Description.Name : name;
    roi.Description.Type = type.empty() ? roi.Description.Type : type;
    for (vtkPolyData* piece : block.Pieces)
    {
      Collect(piece, contours, roi);
    }
    rois.push_back(std::move(roi));
  }
  return rois;
}
}

vtkRTStructureSetWriter::vtkRTStructureSetWriter()
{
  this->SetStructureSetLabel("Reconstruction");
}

vtkRTStructureSetWriter::~vtkRTStructureSetWriter()
{
  this->SetFileName(nullptr);
  this->SetReferenceFileName(nullptr);
  this->SetROIName(nullptr);
  this->SetROIType(nullptr);
  this->SetStructureSetLabel(nullptr);
}

void vtkRTStructureSetWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  const auto shown = [](const char* text) { return text ? text : "(none)"; };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << shown(this->FileName) << "\n";
  os << indent << "ReferenceFileName: " << shown(this->ReferenceFileName) << "\n";
  os << indent << "CopyReferenceROIs: " << this->CopyReferenceROIs << "\n";
  os << indent << "ROIName: " << shown(this->ROIName) << "\n";
  os << indent << "ROIType: " << shown(this->ROIType) << "\n";
  os << indent << "StructureSetLabel: " << shown(this->StructureSetLabel) << "\n";
  os << indent << "GenerationAlgorithm: " << this->GenerationAlgorithm << "\n";
  os << indent << "Holes: " << this->Holes << "\n";
}

int vtkRTStructureSetWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

void vtkRTStructureSetWriter::WriteWhole()
{
  vtkContourMonitor monitor(this);
  std::vector<std::string> report;
  std::vector<recon::WrittenROI> rois = ROIsOf(this, this->GetWhole(), report, monitor);
  const std::vector<std::string> more =
    recon::WriteStructureSet(this->FileName, std::move(rois), OptionsOf(this), monitor);
  report.insert(report.end(), more.begin(), more.end());
  for (const std::string& line : report)
  {
    vtkWarningMacro(<< line);
  }
}
