// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file StageRunner.h
 * @brief Runs the stages of the method: threads, progress bar, stop watch.
 */
#ifndef recon_StageRunner_h
#define recon_StageRunner_h

#include "Base/Monitor.h"
#include "Base/Parallel.h"
#include "Base/SubMonitor.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace recon
{
class StageRunner
{
public:
  /// Progress runs from 0 to progressEnd.
  StageRunner(int threads, Monitor& monitor, double progressEnd)
    : Threads(threads),
      Observer(monitor),
      ProgressEnd(progressEnd)
  {
  }

  /// A stage that comes again adds to its time.
  template <typename Work>
  void Timed(const char* stage, Work work)
  {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    const auto known = std::find_if(
      this->Seconds.begin(), this->Seconds.end(), [&](const auto& s) { return s.first == stage; });
    if (known != this->Seconds.end())
    {
      known->second += elapsed.count();
      return;
    }
    this->Seconds.emplace_back(stage, elapsed.count());
  }

  /// body(i) for every level or slab on the threads that the user allows.
  template <typename Body>
  void ForAll(std::size_t count, double from, double to, const char* stage, Body body) const
  {
    ParallelFor(static_cast<int>(count), this->Threads, body, this->Observer,
      { from * this->ProgressEnd, to * this->ProgressEnd, stage });
  }

  /// For a stage that has progress of its own.
  SubMonitor MonitorOf(double from, double to) const
  {
    return SubMonitor(this->Observer, from * this->ProgressEnd, to * this->ProgressEnd);
  }

  const std::vector<std::pair<std::string, double>>& GetSeconds() const { return this->Seconds; }

private:
  int Threads;
  Monitor& Observer;
  double ProgressEnd;
  std::vector<std::pair<std::string, double>> Seconds;
};
}

#endif
