// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a boundary representation; what can be read is written and read as the same again.
#include "FuzzTarget.h"

#include "BRep/BRepFormatter.h"
#include "BRep/BRepParser.h"

namespace
{
bool Equal(const recon::BRepShell& a, const recon::BRepShell& b)
{
  return a.Vertices == b.Vertices && a.Edges == b.Edges && a.Faces == b.Faces &&
    a.Partners == b.Partners && a.Contours == b.Contours;
}
}

void fuzz::Try(const std::string& bytes)
{
  const std::string name = File(bytes);
  recon::Monitor monitor;
  recon::IsBRep(name);
  const recon::BRep brep = recon::ReadBRep(name, monitor);
  const std::string copy = Name("copy");
  recon::WriteBRep(copy, brep, monitor);
  const recon::BRep again = recon::ReadBRep(copy, monitor);
  Require(again.ShellSets.size() == brep.ShellSets.size(), "another number of shell sets");
  for (std::size_t i = 0; i < brep.ShellSets.size(); ++i)
  {
    const auto& shells = brep.ShellSets[i].Shells;
    const auto& shellsAgain = again.ShellSets[i].Shells;
    Require(shells.size() == shellsAgain.size(), "another number of shells");
    for (std::size_t s = 0; s < shells.size(); ++s)
    {
      Require(Equal(shells[s], shellsAgain[s]), "another shell");
    }
  }
  recon::MakeMesh(brep);
}
