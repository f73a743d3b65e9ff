// SPDX-License-Identifier: GPL-3.0-or-later
// A piece of a loop that would go on for ever ends when the user stops the loop.
#include "Base/Monitor.h"
#include "Base/Parallel.h"
#include "Base/StopSignal.h"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>

using namespace recon;

namespace
{
class StopsAtOnce : public Monitor
{
public:
  bool AbortRequested() override { return this->Calls++ > 0; }

private:
  int Calls = 0;
};

void RunUntilStopped()
{
  const auto start = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - start < std::chrono::seconds(60))
  {
    ThrowIfStopped();
  }
  FAIL() << "nobody stopped this piece";
}
}

TEST(StopSignal, EndsAPieceWhenTheUserStops)
{
  StopsAtOnce monitor;
  EXPECT_THROW(
    ParallelFor(2, 2, [](int) { RunUntilStopped(); }, monitor, { 0, 1, "waiting" }), Aborted);
}

TEST(StopSignal, EndsAPieceWhenAnotherFails)
{
  Monitor monitor;
  const auto body = [](int i)
  { i == 0 ? RunUntilStopped() : throw std::runtime_error("the other one"); };
  EXPECT_THROW(ParallelFor(2, 2, body, monitor, { 0, 1, "waiting" }), std::runtime_error);
}

TEST(StopSignal, IsSilentOutsideOfALoop)
{
  EXPECT_NO_THROW(ThrowIfStopped());
  std::atomic<bool> stop{ true };
  {
    const StopSignal signal(stop);
    EXPECT_THROW(ThrowIfStopped(), Aborted);
  }
  EXPECT_NO_THROW(ThrowIfStopped());
}
