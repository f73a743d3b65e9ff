// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkNUAGESReader.h"

#include "ContourConversion.h"
#include "NUAGES/NUAGESParser.h"
#include "Pieces.h"
#include "RunCore.h"
#include "vtkContourMonitor.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkNUAGESReader);

vtkNUAGESReader::vtkNUAGESReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkNUAGESReader::~vtkNUAGESReader()
{
  this->SetFileName(nullptr);
}

void vtkNUAGESReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << endl;
}

int vtkNUAGESReader::CanReadFile(const char* fileName)
{
  return fileName && (recon::HasExtension(fileName, { ".cnt" }) || recon::IsNUAGES(fileName)) ? 1
                                                                                              : 0;
}

int vtkNUAGESReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->SetErrorCode(recon::RunOnFile(this, this->FileName, "a NUAGES file (.cnt)",
    vtkErrorCode::FileFormatError, { output },
    [&]
    {
      if (recon::RequestedPiece(outputVector).Number > 0)
      {
        return; // one object, and the first piece has it
      }
      vtkContourMonitor monitor(this);
      const recon::ContourFile file = recon::ReadNUAGES(this->FileName, monitor);
      recon::ToPolyData(file.Soup, output);
      recon::SetReport(file.Report, output);
    }));
  return 1;
}
