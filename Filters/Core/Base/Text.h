// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Text.h
 * @brief Numbers in sentences for the user.
 */
#ifndef recon_Text_h
#define recon_Text_h

#include "Base/Geometry.h"

#include <cstdio>
#include <string>

namespace recon
{
/// Six digits, as many as a user can act upon.
inline std::string Text(double x)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

inline std::string Text(const Point3& p)
{
  return "(" + Text(p[0]) + ", " + Text(p[1]) + ", " + Text(p[2]) + ")";
}
}

#endif
