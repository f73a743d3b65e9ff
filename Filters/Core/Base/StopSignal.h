// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file StopSignal.h
 * @brief Lets a long piece of a loop over several threads (Parallel.h) end early.
 */
#ifndef recon_StopSignal_h
#define recon_StopSignal_h

#include <atomic>

namespace recon
{
/// While it lives, its thread works for a loop that `stop` ends.
class StopSignal
{
public:
  explicit StopSignal(const std::atomic<bool>& stop);
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

private:
  const std::atomic<bool>* Outer; ///< of a loop around this one
};

/// Throws Aborted where the loop that this thread works for was ended, by the user or by a piece
/// that failed. Takes about a nanosecond.
void ThrowIfStopped();
}

#endif
