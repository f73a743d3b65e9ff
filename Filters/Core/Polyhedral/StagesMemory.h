// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file StagesMemory.h
 * @brief What stages take, and how what nobody needs any more goes.
 */
#ifndef recon_StagesMemory_h
#define recon_StagesMemory_h

#include "Polyhedral/PolyhedralStages.h"

#include <cstddef>

namespace recon
{
/// Bytes of a level, of the slab below it, and of what both were in earlier rounds.
std::size_t BytesOfLevel(const PolyhedralStages& stages, std::size_t level);

/// Makes most of the levels below this one go, and of the slabs below them; sets Forgotten.
void ForgetBelow(std::size_t level, PolyhedralStages& stages);
}

#endif
