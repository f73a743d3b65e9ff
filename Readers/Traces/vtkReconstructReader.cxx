// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkReconstructReader.h"

#include "Reconstruct/ReconstructParser.h"
#include "RunCore.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkReconstructReader);

int vtkReconstructReader::CanReadFile(const char* fileName)
{
  return fileName &&
      (recon::HasExtension(fileName, { ".ser", ".jser" }) || recon::IsReconstruct(fileName))
    ? 1
    : 0;
}

recon::TracedFile vtkReconstructReader::ReadObjects(
  const std::vector<std::string>& fileNames, recon::Monitor& monitor)
{
  return recon::ReadReconstruct(fileNames.front(), monitor);
}
