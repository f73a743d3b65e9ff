// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestPaths.h"

namespace recon::testing
{
std::string SharedPath(const std::string& name)
{
  return name.empty() ? CONTOUR_SHARED_DATA : std::string(CONTOUR_SHARED_DATA "/") + name;
}

std::string OwnPath(const std::string& name)
{
  return name.empty() ? CONTOUR_SOURCE_DIR : std::string(CONTOUR_SOURCE_DIR "/") + name;
}
}
