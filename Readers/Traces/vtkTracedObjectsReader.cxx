// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkTracedObjectsReader.h"

#include "Common/TracedFile.h"
#include "ContourConversion.h"
#include "FieldArrays.h"
#include "Pieces.h"
#include "RunCore.h"
#include "vtkContourAlgorithm.h"
#include "vtkContourMonitor.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArraySelection.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkTracedObjectsReader);

namespace
{
std::string TypeOf(const recon::LoopSoup::Chain& chain)
{
  return chain.Points.size() == 1 ? "POINT" : chain.Closed ? "CLOSED_PLANAR" : "OPEN_PLANAR";
}

/// soup: the object's, or none where the object is in another piece.
void FillBlock(const recon::TracedObject& object, const recon::LoopSoup& soup, int number,
  const std::string& unit, vtkPolyData* block)
{
  const std::vector<int> chains = recon::ToPolyData(soup, block);
  std::vector<std::string> types;
  std::vector<std::string> names;
  std::vector<int> slices;
  for (const int chain : chains)
  {
    const auto i = static_cast<std::size_t>(chain);
    types.push_back(TypeOf(soup.Chains[i]));
    slices.push_back(object.Slices[i]);
    names.push_back(i < object.Names.size() ? object.Names[i] : std::string());
  }
  recon::AddArray(block->GetCellData(), "GeometricType", types);
  recon::AddArray(block->GetCellData(), "Slice", slices);
  if (!object.Names.empty())
  {
    recon::AddArray(block->GetCellData(), "Name", names);
  }
  vtkFieldData* field = block->GetFieldData();
  recon::AddValue(field, "ROIName", object.Name);
  recon::AddValue(field, "ROINumber", number);
  if (object.HasColor)
  {
    recon::AddValue(field, "ROIColor", object.Color);
  }
  recon::AddValue(field, "LengthUnit", unit);
}
}

vtkTracedObjectsReader::vtkTracedObjectsReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkTracedObjectsReader::~vtkTracedObjectsReader() = default;

void vtkTracedObjectsReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileNames:";
  for (const std::string& name : this->FileNames)
  {
    os << " " << name;
  }
  os << endl;
  os << indent << "SliceSpacing: " << this->SliceSpacing << endl;
  os << indent << "PixelSize: " << this->PixelSize << endl;
  os << indent << "ObjectSelection:" << endl;
  this->ObjectSelection->PrintSelf(os, indent.GetNextIndent());
}

void vtkTracedObjectsReader::SetFileName(const char* fileName)
{
  const std::vector<std::string> names =
    fileName && *fileName ? std::vector<std::string>{ fileName } : std::vector<std::string>{};
  if (names != this->FileNames)
  {
    this->FileNames = names;
    this->Modified();
  }
}

const char* vtkTracedObjectsReader::GetFileName()
{
  return this->FileNames.empty() ? nullptr : this->FileNames.front().c_str();
}

void vtkTracedObjectsReader::AddFileName(const char* fileName)
{
  if (fileName && *fileName)
  {
    this->FileNames.emplace_back(fileName);
    this->Modified();
  }
}

void vtkTracedObjectsReader::RemoveAllFileNames()
{
  this->FileNames.clear();
  this->Modified();
}

vtkDataArraySelection* vtkTracedObjectsReader::GetObjectSelection()
{
  return this->ObjectSelection;
}

const char* vtkTracedObjectsReader::GetReport()
{
  this->ReportText = vtkContourAlgorithm::ReportOf(this);
  return this->ReportText.c_str();
}

vtkMTimeType vtkTracedObjectsReader::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->ObjectSelection->GetMTime());
}

recon::TracedFile vtkTracedObjectsReader::ReadObjects(
  const std::vector<std::string>&, recon::Monitor&)
{
  throw recon::Error("This reader reads no format of its own; take the one of the program.");
}

int vtkTracedObjectsReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  recon::AnswerPieces(outputVector);
  // What is wrong with the file RequestData meets as well, and says once.
  this->Listed.reset();
  const recon::FileOutcome outcome =
    recon::TryFile(this->GetFileName(), this->GetKind(), vtkErrorCode::FileFormatError,
      [this]
      {
        vtkContourMonitor monitor(this);
        this->Listed =
          std::make_unique<recon::TracedFile>(this->ReadObjects(this->FileNames, monitor));
      });
  if (!outcome.IsWhole())
  {
    this->Listed.reset();
    this->ObjectSelection->RemoveAllArrays();
    return 1;
  }
  for (const recon::TracedObject& object : this->Listed->Objects)
  {
    this->ObjectSelection->AddArray(object.Name.c_str()); // keeps the setting of one that is there
  }
  return 1;
}

recon::TracedFile vtkTracedObjectsReader::TakeListed()
{
  if (this->Listed)
  {
    // Read once more next time: the file may have changed.
    const std::unique_ptr<recon::TracedFile> listed = std::move(this->Listed);
    return std::move(*listed);
  }
  vtkContourMonitor monitor(this);
  return this->ReadObjects(this->FileNames, monitor);
}

void vtkTracedObjectsReader::FillOutput(
  const recon::TracedFile& file, recon::Piece piece, vtkDataObject* data)
{
  auto* output = vtkPartitionedDataSetCollection::SafeDownCast(data);
  std::vector<std::size_t> wanted;
  std::vector<std::size_t> weights;
  for (std::size_t i = 0; i < file.Objects.size(); ++i)
  {
    if (this->ObjectSelection->ArrayIsEnabled(file.Objects[i].Name.c_str()))
    {
      wanted.push_back(i);
      weights.push_back(file.Objects[i].Soup.Points.size());
    }
  }
  const recon::RegionShares shares(weights, piece);
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    const recon::TracedObject& object = file.Objects[wanted[i]];
    const auto block = static_cast<unsigned int>(i);
    vtkNew<vtkPolyData> contours;
    FillBlock(object, shares.IsOwn(i) ? object.Soup : recon::LoopSoup(),
      static_cast<int>(wanted[i]) + 1, file.LengthUnit, contours);
    shares.Mark(i, contours);
    output->SetPartition(block, 0, contours);
    output->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), object.Name.c_str());
  }
  recon::AddValue(output->GetFieldData(), "LengthUnit", file.LengthUnit);
  recon::SetReport(file.Report, output);
}

int vtkTracedObjectsReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  this->ErrorCode = recon::RunOnFile(this, this->GetFileName(), this->GetKind(),
    vtkErrorCode::FileFormatError, { output },
    [&] { this->FillOutput(this->TakeListed(), recon::RequestedPiece(outputVector), output); });
  return 1;
}
