// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkNUAGESReader.h"

#include "ContourConversion.h"
#include "NUAGESParser.h"
#include "vtkContourMonitor.h"

#include "vtkErrorCode.h"
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
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("No file name is set: set FileName to a NUAGES file (.cnt).");
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    return 0;
  }
  try
  {
    vtkContourMonitor monitor(this);
    const recon::ContourFile file = recon::ReadNUAGES(this->FileName, monitor);
    recon::ToPolyData(file.Soup, output);
    recon::SetReport(file.Report, output);
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
