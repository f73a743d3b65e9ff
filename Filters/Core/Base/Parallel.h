// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Parallel.h
 * @brief A loop over independent pieces of work on several threads, with progress and abort.
 */
#ifndef recon_Parallel_h
#define recon_Parallel_h

#include "Base/Monitor.h"

#include <algorithm>
#include <cstddef>
#include <functional>

namespace recon
{
/// A share [From, To] of a Monitor's progress and the name of the stage it belongs to.
struct ProgressRange
{
  double From = 0;
  double To = 1;
  const char* Stage = "";
};

/**
 * Call body(i) for i in [0, count) on up to `threads` threads (0: all of the machine).
 *
 * Pieces are handed out in increasing order and must not depend on one another, so the result is
 * the same for any number of threads. The monitor is called from the calling thread only. The first
 * exception of a piece (or Aborted) ends the loop and is rethrown here once all threads are home.
 */
void ParallelFor(int count, int threads, const std::function<void(int)>& body, Monitor& monitor,
  const ProgressRange& range);

/**
 * Call body(from, to) for [0, count) cut into blocks of `block`, in the same way.
 *
 * Fewer than `leastBlocks` blocks are done by the calling thread, as threads cost more than they save.
 */
template <typename Body>
void ParallelForBlocks(std::size_t count, std::size_t block, int threads, const Body& body,
  Monitor& monitor, const ProgressRange& range, std::size_t leastBlocks = 1)
{
  const std::size_t blocks = (count + block - 1) / block;
  const auto run = [&](int number)
  {
    const std::size_t from = static_cast<std::size_t>(number) * block;
    body(from, std::min(count, from + block));
  };
  if (blocks < leastBlocks || blocks == 0)
  {
    for (std::size_t number = 0; number < blocks; ++number)
    {
      run(static_cast<int>(number));
    }
    return;
  }
  ParallelFor(static_cast<int>(blocks), threads, run, monitor, range);
}
}

#endif
