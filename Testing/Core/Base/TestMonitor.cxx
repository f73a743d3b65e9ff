// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Monitor.h"

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
    this->Heard.push_back(
      stage + std::string(" ") + std::to_string(static_cast<int>(fraction * 8)));
  }
};
}

TEST(Monitor, HearsHowFarWhatIs)
{
  Listener listener;
  listener.Update(0.25, "triangulating");
  listener.Update(1, "cutting");
  EXPECT_EQ(listener.Heard, (std::vector<std::string>{ "triangulating 2", "cutting 8" }));
}

TEST(Monitor, StopsWhereItIsAsked)
{
  Listener listener;
  listener.Stop = true;
  EXPECT_THROW(listener.Update(0.5, "triangulating"), Aborted);
  EXPECT_EQ(listener.Heard.size(), 1u); // told before it stops
}

TEST(Monitor, OfItselfDoesNothing)
{
  Monitor monitor;
  EXPECT_NO_THROW(monitor.Update(0.5, "anything"));
  EXPECT_FALSE(monitor.AbortRequested());
}

TEST(Monitor, AnAbortIsNoError)
{
  // What catches errors and shows them must not show that the user stopped.
  const auto stop = [] { throw Aborted(); };
  bool asError = false;
  try
  {
    stop();
  }
  catch (const std::runtime_error&)
  {
    asError = true;
  }
  catch (const Aborted&)
  {
  }
  EXPECT_FALSE(asError);
  EXPECT_STREQ(Error("Slice 3 is empty.").what(), "Slice 3 is empty.");
}
