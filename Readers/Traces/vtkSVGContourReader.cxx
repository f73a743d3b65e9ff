// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSVGContourReader.h"

#include "RunCore.h"
#include "SVG/SVGParser.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSVGContourReader);

int vtkSVGContourReader::CanReadFile(const char* fileName)
{
  return fileName && (recon::HasExtension(fileName, { ".svg" }) || recon::IsSVG(fileName)) ? 1 : 0;
}

recon::TracedFile vtkSVGContourReader::ReadObjects(
  const std::vector<std::string>& fileNames, recon::Monitor& monitor)
{
  return recon::ReadSVG(fileNames, { this->SliceSpacing, this->PixelSize }, monitor);
}
