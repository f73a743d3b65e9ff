// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkImageJReader.h"

#include "ImageJ/ImageJParser.h"
#include "RunCore.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkImageJReader);

int vtkImageJReader::CanReadFile(const char* fileName)
{
  return fileName && (recon::HasExtension(fileName, { ".roi" }) || recon::IsImageJ(fileName)) ? 1
                                                                                              : 0;
}

recon::TracedFile vtkImageJReader::ReadObjects(
  const std::vector<std::string>& fileNames, recon::Monitor& monitor)
{
  return recon::ReadImageJ(fileNames.front(), { this->SliceSpacing, this->PixelSize }, monitor);
}
