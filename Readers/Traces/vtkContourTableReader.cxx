// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkContourTableReader.h"

#include "Table/ContourTableParser.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkContourTableReader);

int vtkContourTableReader::CanReadFile(const char* fileName)
{
  return fileName && (recon::IsContourTable(fileName)) ? 1 : 0;
}

recon::TracedFile vtkContourTableReader::ReadObjects(
  const std::vector<std::string>& fileNames, recon::Monitor& monitor)
{
  return recon::ReadContourTable(
    fileNames.front(), { this->SliceSpacing, this->PixelSize }, monitor);
}
