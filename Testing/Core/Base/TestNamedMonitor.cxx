// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/NamedMonitor.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace recon;

namespace
{
class Listener : public Monitor
{
public:
  bool AbortRequested() override { return this->Stop; }
  bool Stop = false;
  std::vector<std::string> Heard;

protected:
  void OnProgress(double fraction, const char* stage) override
  {
    this->Heard.push_back(std::to_string(fraction).substr(0, 5) + " " + stage);
  }
};
}

TEST(NamedMonitor, TellsItsOwnNameAndNotThatOfItsSteps)
{
  Listener listener;
  NamedMonitor second = NamedMonitor::Pass(listener, 1, 4, "fitting");
  SubMonitor step(second, 0, 0.5);
  step.Update(1, "filling the matrix");
  EXPECT_EQ(listener.Heard, std::vector<std::string>{ "0.375 fitting, 2 of 4" });
}

TEST(NamedMonitor, HandsOnTheWishToStop)
{
  Listener listener;
  NamedMonitor named(listener, 0, 1, "fitting");
  EXPECT_FALSE(named.AbortRequested());
  listener.Stop = true;
  EXPECT_TRUE(named.AbortRequested());
  EXPECT_THROW(named.Update(0.5, "filling"), Aborted);
}
