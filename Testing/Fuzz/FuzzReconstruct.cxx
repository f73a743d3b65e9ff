// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a series of Reconstruct or PyReconstruct. A form feed ends the series' own file; what follows is that of
// its sections 1, 2 and 3.
#include "FuzzTarget.h"

#include "Readers/Soundness.h"
#include "Reconstruct/ReconstructParser.h"

void fuzz::Try(const std::string& bytes)
{
  std::string name;
  std::size_t begin = 0;
  for (int part = 0; part < 4; ++part)
  {
    const std::size_t end = begin > bytes.size() ? begin : bytes.find('\f', begin);
    const std::string text =
      begin > bytes.size() ? std::string() : bytes.substr(begin, end - begin);
    const std::string file = File(text, part == 0 ? "s.ser" : "s." + std::to_string(part));
    name = part == 0 ? file : name;
    begin = end == std::string::npos || end > bytes.size() ? bytes.size() + 1 : end + 1;
  }
  recon::Monitor monitor;
  recon::IsReconstruct(name);
  RequireNone(readertesting::FaultOf(recon::ReadReconstruct(name, monitor)));
}
