// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkIMODReader.h"

#include "IMOD/IMODParser.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkIMODReader);

int vtkIMODReader::CanReadFile(const char* fileName)
{
  return fileName && (recon::IsIMOD(fileName)) ? 1 : 0;
}

recon::TracedFile vtkIMODReader::ReadObjects(
  const std::vector<std::string>& fileNames, recon::Monitor& monitor)
{
  return recon::ReadIMOD(fileNames.front(), monitor);
}
