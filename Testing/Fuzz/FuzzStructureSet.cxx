// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a DICOM RT structure set, with the contours of all its ROIs.
#include "FuzzTarget.h"

#include "DICOM/StructureSetFile.h"
#include "Readers/Soundness.h"

void fuzz::Try(const std::string& bytes)
{
  const std::string name = File(bytes);
  recon::Monitor monitor;
  recon::StructureSetFile::IsStructureSet(name);
  recon::StructureSetFile file(name);
  RequireNone(readertesting::FaultOf(file, monitor));
}
