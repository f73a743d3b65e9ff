// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as an ROI of ImageJ, or an archive of them.
#include "FuzzTarget.h"

#include "ImageJ/ImageJParser.h"
#include "Readers/Soundness.h"

void fuzz::Try(const std::string& bytes)
{
  const std::string name = File(bytes);
  recon::Monitor monitor;
  recon::IsImageJ(name);
  RequireNone(readertesting::FaultOf(recon::ReadImageJ(name, {}, monitor)));
}
