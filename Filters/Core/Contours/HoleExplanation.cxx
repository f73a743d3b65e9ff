// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/HoleExplanation.h"

#include "Contours/ContourNotes.h"
#include "Planar/HoleRule.h"

#include <cctype>

namespace recon
{
std::string DescribeHoles(HoleRule rule, const HoleFindings& found)
{
  std::string text = NameOf(rule);
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  if (rule == HoleRule::Automatic)
  {
    text += " (automatic)";
  }
  if (found.ExclusiveOr)
  {
    text += ", as CLOSEDPLANAR_XOR contours ask for";
  }
  const std::size_t holes = found.Opposite + found.Same + found.Keyholes;
  text += ": " + (holes > 0 ? Counted(holes, "hole") : std::string("no holes"));
  std::string how;
  const auto add = [&how](std::size_t count, const char* what)
  {
    if (count > 0)
    {
      how += (how.empty() ? " (" : ", ") + std::to_string(count) + what;
    }
  };
  add(found.Opposite, " drawn opposite to the wall around");
  add(found.Same, " drawn in the direction of the wall around");
  add(found.Keyholes, " by keyholes");
  text += how.empty() ? "" : how + ")";
  if (found.Swallowed > 0)
  {
    text += ", " + Counted(found.Swallowed, "contour") + " within solid left out";
  }
  return text + ".";
}
}
