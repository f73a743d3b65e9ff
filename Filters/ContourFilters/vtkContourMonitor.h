// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkContourMonitor
 * @brief Lets the core report to, and be stopped through, a vtkAlgorithm.
 *
 * Lives on the stack of RequestData for one call of the core, whose progress it maps to [from, to]
 * of the algorithm's own. The core calls its monitor from the thread it was called from, which is
 * the thread of RequestData, as VTK requires. Progress events reach the user interface at most
 * every 50 ms; the abort flag is looked at on every call.
 */
#ifndef vtkContourMonitor_h
#define vtkContourMonitor_h

#include "Base/Monitor.h"

#include "vtkAlgorithm.h"

#include <algorithm>
#include <chrono>
#include <string>

class vtkContourMonitor : public recon::Monitor
{
public:
  explicit vtkContourMonitor(vtkAlgorithm* algorithm, double from = 0.0, double to = 1.0)
    : Algorithm(algorithm),
      From(from),
      To(to)
  {
  }
  ~vtkContourMonitor() override { this->Algorithm->SetProgressText(nullptr); }
  vtkContourMonitor(const vtkContourMonitor&) = delete;
  vtkContourMonitor& operator=(const vtkContourMonitor&) = delete;

  bool AbortRequested() override { return IsAborted(this->Algorithm, 0); }

protected:
  void OnProgress(double fraction, const char* stage) override
  {
    const auto now = std::chrono::steady_clock::now();
    const bool newStage = this->Stage != stage;
    if (!newStage && now - this->Last < std::chrono::milliseconds(50))
    {
      return;
    }
    if (newStage)
    {
      this->Stage = stage;
      this->Algorithm->SetProgressText(stage);
    }
    this->Last = now;
    // Stages that estimate their share, or repeat, would have the bar go back.
    this->Highest = std::max(this->Highest, fraction);
    this->Algorithm->UpdateProgress(this->From + this->Highest * (this->To - this->From));
  }

private:
  /// Also by a filter further down, where VTK knows of that (after 9.1).
  template <typename Any>
  static auto IsAborted(Any* algorithm, int) -> decltype(algorithm->CheckAbort())
  {
    return algorithm->CheckAbort();
  }
  template <typename Any>
  static bool IsAborted(Any* algorithm, long)
  {
    return algorithm->GetAbortExecute() != 0;
  }

  vtkAlgorithm* Algorithm;
  double From;
  double To;
  double Highest = 0;
  std::string Stage;
  std::chrono::steady_clock::time_point Last{};
};

#endif
