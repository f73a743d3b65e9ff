// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as an IMOD model.
#include "FuzzTarget.h"

#include "IMOD/IMODParser.h"
#include "Readers/Soundness.h"

void fuzz::Try(const std::string& bytes)
{
  const std::string name = File(bytes);
  recon::Monitor monitor;
  recon::IsIMOD(name);
  RequireNone(readertesting::FaultOf(recon::ReadIMOD(name, monitor)));
}
