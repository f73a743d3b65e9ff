// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SubMonitor.h
 * @brief One progress bar over several stages: a stage's [0, 1] is a share of the whole.
 */
#ifndef recon_SubMonitor_h
#define recon_SubMonitor_h

#include "Base/Monitor.h"

namespace recon
{
/**
 * @class SubMonitor
 * @brief Hands progress in [0, 1] on to a parent as progress in [From, To].
 */
class SubMonitor final : public Monitor
{
public:
  SubMonitor(Monitor& parent, double from, double to) : Parent(parent), From(from), To(to) {}

  bool AbortRequested() override { return this->Parent.AbortRequested(); }

protected:
  void OnProgress(double fraction, const char* stage) override
  {
    this->Parent.Update(this->From + (this->To - this->From) * fraction, stage);
  }

private:
  Monitor& Parent;
  double From;
  double To;
};

/**
 * @class AbortMonitor
 * @brief Hands on the wish to stop, and no progress: for steps whose share of the whole is not
 * known.
 */
class AbortMonitor final : public Monitor
{
public:
  explicit AbortMonitor(Monitor& parent) : Parent(parent) {}

  bool AbortRequested() override { return this->Parent.AbortRequested(); }

private:
  Monitor& Parent;
};
}

#endif
