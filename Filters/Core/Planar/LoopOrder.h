// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file LoopOrder.h
 * @brief One way to write a closed loop, so that loops can be compared.
 */
#ifndef recon_LoopOrder_h
#define recon_LoopOrder_h

#include <algorithm>
#include <vector>

namespace recon
{
/// Starts at the smallest number and goes on to its smaller neighbour: equal for equal loops of
/// distinct numbers, wherever they start and whichever way they run.
inline std::vector<int> CanonicalLoop(std::vector<int> loop)
{
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  if (loop.size() > 2 && loop.back() < loop[1])
  {
    std::reverse(loop.begin() + 1, loop.end());
  }
  return loop;
}
}

#endif
