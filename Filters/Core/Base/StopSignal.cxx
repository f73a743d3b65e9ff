// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/StopSignal.h"

#include "Base/Monitor.h"

namespace recon
{
namespace
{
thread_local const std::atomic<bool>* Current = nullptr;
}

StopSignal::StopSignal(const std::atomic<bool>& stop) : Outer(Current)
{
  Current = &stop;
}

StopSignal::~StopSignal()
{
  Current = this->Outer;
}

void ThrowIfStopped()
{
  if (Current && Current->load(std::memory_order_relaxed))
  {
    throw Aborted();
  }
}
}
