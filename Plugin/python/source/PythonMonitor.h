// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PythonMonitor.h
 * @brief The core at work for Python: without the interpreter's lock, with progress and Ctrl-C.
 */
#ifndef PythonMonitor_h
#define PythonMonitor_h

#include "Base/Monitor.h"

#include <nanobind/nanobind.h>

#include <chrono>

namespace recon
{
namespace nb = nanobind;

/**
 * @class PythonMonitor
 * @brief Asks the interpreter some twenty times a second whether a signal has come, and tells a
 * callable how far the work is.
 *
 * The callable gets (fraction, stage); where it returns False, the work stops by Aborted. What it
 * raises, and KeyboardInterrupt, end the work and reach the caller.
 */
class PythonMonitor final : public Monitor
{
public:
  /// @param progress a callable or None; outlives this.
  explicit PythonMonitor(nb::handle progress) : Progress(progress) {}

protected:
  void OnProgress(double fraction, const char* stage) override;

private:
  nb::handle Progress;
  std::chrono::steady_clock::time_point Next;
};

/// Runs work(monitor) while other threads of Python run, too, and gives back what it returns.
template <typename Work>
auto RunWithoutLock(nb::handle progress, const Work& work)
{
  PythonMonitor monitor(progress);
  const nb::gil_scoped_release unlocked;
  return work(static_cast<Monitor&>(monitor));
}
}

#endif
