// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a set of cross-sections (.csl) or a network of curves (.contour), by what they begin with.
#include "FuzzTarget.h"

#include "CurveNetwork/CurveNetworkParser.h"
#include "Readers/Soundness.h"

void fuzz::Try(const std::string& bytes)
{
  const std::string name = File(bytes);
  recon::Monitor monitor;
  recon::CurveNetworkFormatOf(name);
  RequireNone(readertesting::FaultOf(recon::ReadCurveNetwork(name, monitor)));
}
