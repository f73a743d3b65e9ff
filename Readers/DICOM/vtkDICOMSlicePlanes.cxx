// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkDICOMSlicePlanes.h"

#include "ContourConversion.h"
#include "DICOM/ReadReferenceSlices.h"
#include "Pieces.h"
#include "RunCore.h"
#include "vtkContourMonitor.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

vtkStandardNewMacro(vtkDICOMSlicePlanes);

namespace
{
void AddFieldData(const recon::SlicesOfReference& slices, vtkPolyData* output)
{
  vtkNew<vtkStringArray> frame;
  frame->SetName("FrameOfReferenceUID");
  frame->InsertNextValue(slices.FrameOfReferenceUID);
  output->GetFieldData()->AddArray(frame);
  vtkNew<vtkDoubleArray> tolerance;
  tolerance->SetName("ContourTolerance");
  tolerance->InsertNextValue(slices.Tolerance);
  output->GetFieldData()->AddArray(tolerance);
  recon::SetReport(slices.Report, output);
}

void ToPolyData(const std::vector<recon::ReferenceSlice>& slices, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> rectangles;
  vtkNew<vtkStringArray> images;
  images->SetName("SOPInstanceUID");
  vtkNew<vtkDoubleArray> pixels;
  pixels->SetName("PixelArea");
  for (const recon::ReferenceSlice& slice : slices)
  {
    rectangles->InsertNextCell(static_cast<int>(slice.Outline.size()));
    for (const recon::Point3& corner : slice.Outline)
    {
      rectangles->InsertCellPoint(points->InsertNextPoint(corner.data()));
    }
    images->InsertNextValue(slice.InstanceUID);
    pixels->InsertNextValue(slice.PixelArea);
  }
  output->SetPoints(points);
  output->SetPolys(rectangles);
  output->GetCellData()->AddArray(images);
  output->GetCellData()->AddArray(pixels);
}
}

vtkDICOMSlicePlanes::vtkDICOMSlicePlanes()
{
  this->SetNumberOfInputPorts(0);
}

vtkDICOMSlicePlanes::~vtkDICOMSlicePlanes()
{
  this->SetFileName(nullptr);
  this->SetFrameOfReferenceUID(nullptr);
}

void vtkDICOMSlicePlanes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << endl;
  os << indent << "FrameOfReferenceUID: "
     << (this->FrameOfReferenceUID ? this->FrameOfReferenceUID : "(none)") << endl;
}

int vtkDICOMSlicePlanes::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (recon::RequestedPiece(outputVector).Number > 0)
  {
    return 1; // all is in the first piece
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->SetErrorCode(recon::RunOnFile(this, this->FileName,
    "an RT structure set, or to an image of the series (.dcm)", vtkErrorCode::FileFormatError,
    { output },
    [&]
    {
      vtkContourMonitor monitor(this);
      const recon::SlicesOfReference slices = recon::ReadReferenceSlices(
        this->FileName, this->FrameOfReferenceUID ? this->FrameOfReferenceUID : "", monitor);
      ToPolyData(slices.Slices, output);
      AddFieldData(slices, output);
    }));
  return 1;
}
