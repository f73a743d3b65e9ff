// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkNUAGESReader.h"

#include "Common/FileOutcome.h"
#include "ContourConversion.h"
#include "NUAGES/NUAGESParser.h"
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
  return fileName && recon::IsNUAGES(fileName) ? 1 : 0;
}

int vtkNUAGESReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const recon::FileOutcome outcome =
    recon::TryFile(this->FileName, "a NUAGES file (.cnt)", vtkErrorCode::FileFormatError,
      [&]
      {
        vtkContourMonitor monitor(this);
        const recon::ContourFile file = recon::ReadNUAGES(this->FileName, monitor);
        recon::ToPolyData(file.Soup, output);
        recon::SetReport(file.Report, output);
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
