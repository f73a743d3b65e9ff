// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a table of points.
#include "FuzzTarget.h"

#include "Readers/Soundness.h"
#include "Table/ContourTableParser.h"

void fuzz::Try(const std::string& bytes)
{
  const std::string name = File(bytes);
  recon::Monitor monitor;
  recon::IsContourTable(name);
  RequireNone(readertesting::FaultOf(recon::ReadContourTable(name, {}, monitor)));
}
