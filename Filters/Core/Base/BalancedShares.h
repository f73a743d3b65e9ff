// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file BalancedShares.h
 * @brief Work of known weights in shares of about the same weight.
 */
#ifndef recon_BalancedShares_h
#define recon_BalancedShares_h

#include <cstddef>
#include <vector>

namespace recon
{
/**
 * The share of each weight, from 0 to shares - 1: the heaviest first, each to the share that is
 * lightest then. The heaviest share is at most 4/3 of what it is at best (R. L. Graham, Bounds on
 * multiprocessing timing anomalies, 1969). Equal weights go by their order and equal shares by their
 * number, so that everybody who asks gets the same answer.
 *
 * @param shares at least 1
 */
std::vector<int> BalancedShares(const std::vector<std::size_t>& weights, int shares);
}

#endif
