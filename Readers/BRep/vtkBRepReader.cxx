// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkBRepReader.h"

#include "BRep/BRepParser.h"
#include "Common/FileOutcome.h"
#include "ContourConversion.h"
#include "vtkContourMonitor.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkBRepReader);

namespace
{
/// A number a cell: vtkPolyData counts lines before polygons.
void AddCellArray(const char* name, const std::vector<int>& ofContours,
  const std::vector<int>& ofTriangles, vtkPolyData* output)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  array->Allocate(static_cast<vtkIdType>(ofContours.size() + ofTriangles.size()));
  for (const std::vector<int>* numbers : { &ofContours, &ofTriangles })
  {
    for (const int number : *numbers)
    {
      array->InsertNextValue(number);
    }
  }
  output->GetCellData()->AddArray(array);
}

void FillPolyData(const recon::ShelledMesh& shells, vtkPolyData* output)
{
  recon::ToPolyData(shells.Mesh, output);
  vtkNew<vtkCellArray> lines;
  for (const std::vector<int>& contour : shells.Contours)
  {
    lines->InsertNextCell(static_cast<int>(contour.size()) + 1);
    for (const int point : contour)
    {
      lines->InsertCellPoint(point);
    }
    lines->InsertCellPoint(contour.front());
  }
  output->SetLines(lines);
  AddCellArray("ShellId", shells.ShellOfContour, shells.ShellOfTriangle, output);
  AddCellArray("ShellSet", shells.ShellSetOfContour, shells.ShellSetOfTriangle, output);
}
}

vtkBRepReader::vtkBRepReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkBRepReader::~vtkBRepReader()
{
  this->SetFileName(nullptr);
}

void vtkBRepReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << endl;
}

int vtkBRepReader::CanReadFile(const char* fileName)
{
  return fileName && recon::IsBRep(fileName) ? 1 : 0;
}

int vtkBRepReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const recon::FileOutcome outcome = recon::TryFile(this->FileName,
    "a boundary representation (.brep)", vtkErrorCode::FileFormatError,
    [&]
    {
      vtkContourMonitor monitor(this);
      FillPolyData(recon::MakeMesh(recon::ReadBRep(this->FileName, monitor)), output);
    });
  this->SetErrorCode(outcome.ErrorCode);
  if (!outcome.IsWhole())
  {
    output->Initialize();
  }
  if (!outcome.Sentence.empty())
  {
    vtkErrorMacro(<< outcome.Sentence);
    return 0;
  }
  return 1;
}
