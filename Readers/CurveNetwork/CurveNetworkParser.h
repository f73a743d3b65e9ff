// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file CurveNetworkParser.h
 * @brief Cross-sections with materials from a file of either format, told by its content.
 */
#ifndef recon_CurveNetworkParser_h
#define recon_CurveNetworkParser_h

#include "Base/Monitor.h"
#include "CurveNetwork/CurveNetwork.h"

#include <string>

namespace recon
{
enum class CurveNetworkFormat
{
  None,
  CSL,
  Contour
};

/// By the file's content, whatever its name.
CurveNetworkFormat CurveNetworkFormatOf(const std::string& fileName);

/// @throws Error where it is neither, or not whole
CurveNetwork ReadCurveNetwork(const std::string& fileName, Monitor& monitor);
}

#endif
