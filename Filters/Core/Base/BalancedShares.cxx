// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/BalancedShares.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

namespace recon
{
std::vector<int> BalancedShares(const std::vector<std::size_t>& weights, int shares)
{
  std::vector<std::size_t> order(weights.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return weights[a] > weights[b]; });
  using Load = std::pair<std::size_t, int>; // weight so far, share
  std::priority_queue<Load, std::vector<Load>, std::greater<>> loads;
  for (int share = 0; share < shares; ++share)
  {
    loads.emplace(0, share);
  }
  std::vector<int> shareOf(weights.size(), 0);
  for (const std::size_t i : order)
  {
    const auto [load, share] = loads.top();
    loads.pop();
    shareOf[i] = share;
    loads.emplace(load + weights[i], share);
  }
  return shareOf;
}
}
