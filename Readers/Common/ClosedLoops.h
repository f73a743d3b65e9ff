// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ClosedLoops.h
 * @brief Closed contours for the formats that hold nothing else.
 */
#ifndef recon_ClosedLoops_h
#define recon_ClosedLoops_h

#include "Base/Monitor.h"
#include "Contours/ContourSet.h"

#include <string>

namespace recon
{
/**
 * Closed loops as they are, loose pieces (what ParaView's Slice gives) chained to closed ones.
 *
 * @param fileHolds for the sentence of an error: "NUAGES files hold"
 * @param looseVertices counts the single vertices, which are left out
 * @throws Error naming the first piece that does not close
 */
LoopSoup CloseLoops(
  LoopSoup soup, const std::string& fileHolds, int& looseVertices, Monitor& monitor);
}

#endif
