// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkDICOMSlicePlanes.h"

#include "ReferenceSlices.h"
#include "vtkContourMonitor.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkErrorCode.h"
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
void ToPolyData(const std::vector<recon::ReferenceSlice>& slices, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> rectangles;
  vtkNew<vtkStringArray> images;
  images->SetName("SOPInstanceUID");
  for (const recon::ReferenceSlice& slice : slices)
  {
    rectangles->InsertNextCell(static_cast<int>(slice.Outline.size()));
    for (const recon::Point3& corner : slice.Outline)
    {
      rectangles->InsertCellPoint(points->InsertNextPoint(corner.data()));
    }
    images->InsertNextValue(slice.InstanceUID);
  }
  output->SetPoints(points);
  output->SetPolys(rectangles);
  output->GetCellData()->AddArray(images);
}
}

vtkDICOMSlicePlanes::vtkDICOMSlicePlanes()
{
  this->SetNumberOfInputPorts(0);
}

vtkDICOMSlicePlanes::~vtkDICOMSlicePlanes()
{
  this->SetFileName(nullptr);
}

void vtkDICOMSlicePlanes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << endl;
}

int vtkDICOMSlicePlanes::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("No file name is set: set FileName to an RT structure set, or to an image of the "
                  "series (.dcm).");
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    return 0;
  }
  try
  {
    vtkContourMonitor monitor(this);
    ToPolyData(recon::ReadReferenceSlices(this->FileName, monitor), output);
    this->SetErrorCode(vtkErrorCode::NoError);
    return 1;
  }
  catch (const recon::Aborted&)
  {
    output->Initialize();
    return 1;
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    this->SetErrorCode(vtkErrorCode::FileFormatError);
    return 0;
  }
}
