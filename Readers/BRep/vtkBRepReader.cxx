// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkBRepReader.h"

#include "BRep/BRepParser.h"
#include "ContourConversion.h"
#include "FieldArrays.h"
#include "Pieces.h"
#include "RunCore.h"
#include "vtkContourMonitor.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkBRepReader);

namespace
{
/// A number a cell: vtkPolyData counts lines before polygons.
void AddNumbers(const char* name, std::vector<int> numbers, const std::vector<int>& ofTriangles,
  vtkPolyData* output)
{
  numbers.insert(numbers.end(), ofTriangles.begin(), ofTriangles.end());
  recon::AddArray(output->GetCellData(), name, numbers);
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
  AddNumbers("ShellId", shells.ShellOfContour, shells.ShellOfTriangle, output);
  AddNumbers("ShellSet", shells.ShellSetOfContour, shells.ShellSetOfTriangle, output);
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
  return fileName && (recon::HasExtension(fileName, { ".brep" }) || recon::IsBRep(fileName)) ? 1
                                                                                             : 0;
}

int vtkBRepReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (recon::RequestedPiece(outputVector).Number > 0)
  {
    return 1; // all is in the first piece
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->SetErrorCode(recon::RunOnFile(this, this->FileName, "a boundary representation (.brep)",
    vtkErrorCode::FileFormatError, { output },
    [&]
    {
      vtkContourMonitor monitor(this);
      FillPolyData(recon::MakeMesh(recon::ReadBRep(this->FileName, monitor)), output);
    }));
  return 1;
}
