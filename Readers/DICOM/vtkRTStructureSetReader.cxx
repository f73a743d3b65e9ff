// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkRTStructureSetReader.h"

#include "ContourConversion.h"
#include "DICOM/StructureSetFile.h"
#include "Pieces.h"
#include "RunCore.h"
#include "vtkContourAlgorithm.h"
#include "vtkContourMonitor.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArraySelection.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

vtkStandardNewMacro(vtkRTStructureSetReader);

namespace
{
void AddString(const char* name, const std::string& value, vtkFieldData* fieldData)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  fieldData->AddArray(array);
}

void AddROIFieldData(const recon::StructureSetROI& roi, vtkFieldData* fieldData)
{
  AddString("ROIName", roi.Name, fieldData);
  AddString("ROIType", roi.Type, fieldData);
  if (!roi.FrameOfReferenceUID.empty())
  {
    AddString("FrameOfReferenceUID", roi.FrameOfReferenceUID, fieldData);
  }
  vtkNew<vtkIntArray> number;
  number->SetName("ROINumber");
  number->InsertNextValue(roi.Number);
  fieldData->AddArray(number);
  if (!roi.HasColor)
  {
    return;
  }
  vtkNew<vtkUnsignedCharArray> color;
  color->SetName("ROIColor");
  color->SetNumberOfComponents(3);
  color->InsertNextTuple3(roi.Color[0], roi.Color[1], roi.Color[2]);
  fieldData->AddArray(color);
}

void FillBlock(const recon::StructureSetContours& contours, vtkPolyData* block)
{
  const std::vector<int> chains = recon::ToPolyData(contours.File.Soup, block);
  vtkNew<vtkStringArray> types;
  types->SetName("GeometricType");
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("ContourNumber");
  for (const int chain : chains)
  {
    types->InsertNextValue(contours.GeometricTypes[chain]);
    numbers->InsertNextValue(contours.File.Soup.Chains[chain].Source + 1);
  }
  block->GetCellData()->AddArray(types);
  block->GetCellData()->AddArray(numbers);
  recon::SetReport(contours.File.Report, block);
}

std::vector<std::size_t> WeightsOf(const std::vector<recon::StructureSetContours>& contours)
{
  std::vector<std::size_t> weights;
  for (const recon::StructureSetContours& region : contours)
  {
    weights.push_back(region.File.Soup.Points.size());
  }
  return weights;
}
}

vtkRTStructureSetReader::vtkRTStructureSetReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkRTStructureSetReader::~vtkRTStructureSetReader()
{
  this->SetFileName(nullptr);
}

void vtkRTStructureSetReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << endl;
  os << indent << "ROISelection:" << endl;
  this->ROISelection->PrintSelf(os, indent.GetNextIndent());
}

vtkDataArraySelection* vtkRTStructureSetReader::GetROISelection()
{
  return this->ROISelection;
}

const char* vtkRTStructureSetReader::GetReport()
{
  this->ReportText = vtkContourAlgorithm::ReportOf(this);
  return this->ReportText.c_str();
}

vtkMTimeType vtkRTStructureSetReader::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->ROISelection->GetMTime());
}

int vtkRTStructureSetReader::CanReadFile(const char* fileName)
{
  try
  {
    return fileName && recon::StructureSetFile::IsStructureSet(fileName) ? 1 : 0;
  }
  catch (const std::exception&)
  {
    return 0; // whatever it is, it is nothing that this reader can read
  }
}

void vtkRTStructureSetReader::UpdateSelection(const std::vector<std::string>& names)
{
  const auto isListed = [&names](const char* name)
  { return std::find(names.begin(), names.end(), name) != names.end(); };
  // Names that are left from another file say nothing; names that the user chose for this one do.
  const bool isOtherFile = !this->ListedFile.empty() && this->ListedFile != this->FileName;
  if (isOtherFile)
  {
    this->UnknownSelected.clear();
  }
  for (int i = this->ROISelection->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    const std::string name = this->ROISelection->GetArrayName(i);
    if (isListed(name.c_str()))
    {
      continue;
    }
    if (!isOtherFile && this->ROISelection->GetArraySetting(i))
    {
      this->UnknownSelected.push_back(name);
    }
    this->ROISelection->RemoveArrayByName(name.c_str());
  }
  for (const std::string& name : names)
  {
    this->ROISelection->AddArray(name.c_str()); // keeps the setting of one that is there
  }
  this->ListedFile = this->FileName;
}

int vtkRTStructureSetReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  recon::AnswerPieces(outputVector);
  // What is wrong with the file RequestData meets as well, and says once.
  if (!this->FileName)
  {
    return 1;
  }
  try
  {
    const recon::StructureSetFile file(this->FileName);
    std::vector<std::string> names;
    for (const recon::StructureSetROI& roi : file.GetROIs())
    {
      names.push_back(roi.Name);
    }
    this->UpdateSelection(names);
  }
  catch (const std::exception&)
  {
    this->ROISelection->RemoveAllArrays();
  }
  return 1;
}

std::vector<std::size_t> vtkRTStructureSetReader::WantedOf(
  const std::vector<recon::StructureSetROI>& rois)
{
  std::vector<std::size_t> wanted;
  for (std::size_t i = 0; i < rois.size(); ++i)
  {
    if (this->ROISelection->ArrayIsEnabled(rois[i].Name.c_str()))
    {
      wanted.push_back(i);
    }
  }
  return wanted;
}

int vtkRTStructureSetReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  auto* output = vtkPartitionedDataSetCollection::GetData(outputVector);
  this->SetErrorCode(recon::RunOnFile(this, this->FileName, "a DICOM RT structure set (.dcm)",
    vtkErrorCode::FileFormatError, { output },
    [&]
    {
      recon::StructureSetFile file(this->FileName);
      const std::vector<recon::StructureSetROI>& rois = file.GetROIs();
      std::vector<std::string> report = file.GetReport();
      for (const std::string& name : this->UnknownSelected)
      {
        report.push_back("The selected ROI \"" + name + "\" is not in the file.");
      }
      const std::vector<std::size_t> wanted = this->WantedOf(rois);
      std::vector<recon::StructureSetContours> contours;
      for (std::size_t i = 0; i < wanted.size(); ++i)
      {
        const auto count = static_cast<double>(wanted.size());
        vtkContourMonitor monitor(
          this, static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
        contours.push_back(file.ReadContours(static_cast<int>(wanted[i]), monitor));
        const std::vector<std::string>& odd = contours.back().File.Report;
        report.insert(report.end(), odd.begin(), odd.end());
      }
      const recon::RegionShares shares(WeightsOf(contours), recon::RequestedPiece(outputVector));
      for (std::size_t i = 0; i < wanted.size(); ++i)
      {
        const recon::StructureSetROI& roi = rois[wanted[i]];
        const auto block = static_cast<unsigned int>(i);
        vtkNew<vtkPolyData> contourData;
        FillBlock(shares.IsOwn(i) ? contours[i] : recon::StructureSetContours(), contourData);
        contours[i] = recon::StructureSetContours(); // they take as much memory as the block
        AddROIFieldData(roi, contourData->GetFieldData());
        shares.Mark(i, contourData);
        output->SetPartition(block, 0, contourData);
        output->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), roi.Name.c_str());
      }
      recon::SetReport(report, output);
    }));
  return 1;
}
