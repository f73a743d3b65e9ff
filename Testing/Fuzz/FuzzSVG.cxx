// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a drawing.
#include "FuzzTarget.h"

#include "Readers/Soundness.h"
#include "SVG/SVGParser.h"

void fuzz::Try(const std::string& bytes)
{
  const std::string name = File(bytes);
  recon::Monitor monitor;
  recon::IsSVG(name);
  RequireNone(readertesting::FaultOf(recon::ReadSVG({ name }, {}, monitor)));
}
