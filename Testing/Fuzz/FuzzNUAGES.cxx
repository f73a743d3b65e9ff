// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a NUAGES file.
#include "FuzzTarget.h"

#include "NUAGES/NUAGESParser.h"
#include "Readers/Soundness.h"

void fuzz::Try(const std::string& bytes)
{
  const std::string name = File(bytes);
  recon::Monitor monitor;
  recon::IsNUAGES(name);
  RequireNone(readertesting::FaultOf(recon::ReadNUAGES(name, monitor)));
}
