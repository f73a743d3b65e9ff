// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file FarthestPoint.h
 * @brief How far from the origin points may be.
 */
#ifndef recon_FarthestPoint_h
#define recon_FarthestPoint_h

namespace recon
{
/// Beyond this, products of coordinates, and what exact predicates are asked about, could overflow.
constexpr double FarthestPoint = 1e60;
}

#endif
