// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file NumberText.h
 * @brief Numbers in sentences for the user.
 */
#ifndef recon_NumberText_h
#define recon_NumberText_h

#include <cstdio>
#include <string>

namespace recon
{
/// Four digits, as many as a user can act upon.
inline std::string Text(double x)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}
}

#endif
