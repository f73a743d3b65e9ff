// SPDX-License-Identifier: GPL-3.0-or-later
// What the polyhedral method says to input that it cannot use, and to a user who wants to stop.
#include "PolyhedralShapes.h"
#include "SurfaceInvariants.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

using namespace recon;
using namespace recon::testing;

namespace
{
std::string SentenceFor(const ContourSet& contours)
{
  try
  {
    BuildSurface(contours);
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "";
}

/// Counts Update calls, checks them, and asks to stop at one of them.
class StoppingMonitor : public Monitor
{
public:
  explicit StoppingMonitor(int stopAt) : StopAt(stopAt) {}

  bool AbortRequested() override { return this->Calls == this->StopAt; }

  int Calls = 0;
  double Last = 0;
  int Backwards = 0;
  int OutOfRange = 0;

protected:
  void OnProgress(double fraction, const char* stage) override
  {
    ++this->Calls;
    this->Backwards += fraction < this->Last;
    this->OutOfRange += !(fraction >= 0 && fraction <= 1) || stage == nullptr;
    this->Last = fraction;
  }

private:
  int StopAt;
};
}

TEST(PolyhedralSurfaceInvalid, OneLevel)
{
  const std::string sentence = SentenceFor(BuildStack({ { Rectangle(0, 0, 1, 1) } }));
  EXPECT_NE(sentence.find("one plane"), std::string::npos) << sentence;
}

TEST(PolyhedralSurfaceInvalid, PlanesOfSeveralDirections)
{
  SoupMaker maker;
  maker.Loop(Rectangle(0, 0, 1, 1), 0);
  maker.Loop(Rectangle(0, 0, 1, 1), 1);
  maker.Chain({ { 0, 0.5, -1 }, { 1, 0.5, -1 }, { 1, 0.5, 2 }, { 0, 0.5, 2 } }, true);
  const std::string sentence = SentenceFor(maker.Build(false));
  EXPECT_NE(sentence.find("Implicit Surface"), std::string::npos) << sentence;
}

TEST(PolyhedralSurfaceInvalid, NothingButContoursThatFaceNothing)
{
  // No solid at all is an answer, if it is said; it must not be a crash.
  const ContourSet contours =
    BuildStack({ { Rectangle(0, 0, 1, 1) }, { Rectangle(100, 100, 101, 101) } });
  const PolyhedralSurface surface = BuildSurface(contours);
  if (surface.Mesh.Triangles.empty())
  {
    EXPECT_EQ(ContoursLeftOut(surface).Wholly.size(), 2u);
  }
  else
  {
    ExpectKeepsPromises(surface, contours);
  }
}

/// What is said of a forced join of the first contour and the last.
std::string JoinSentenceFor(const ContourSet& contours)
{
  PolyhedralOptions options;
  options.Mapping = PolyhedralOptions::Overlap;
  options.ForcedJoins = { { 0, static_cast<int>(contours.Contours.size()) - 1 } };
  for (const std::string& line : BuildSurface(contours, options).Report)
  {
    if (line.find("was asked for but cannot be made") != std::string::npos)
    {
      return line;
    }
  }
  return "";
}

TEST(PolyhedralSurfaceInvalid, AJoinThatCannotBeMadeHasATrueReason)
{
  // Far away from both is a third, so that levels are not shifted onto one another.
  const std::string beside =
    JoinSentenceFor(BuildStack({ { Circle(0, 0, 1, 20), Circle(0, 50, 1, 20) },
      { Circle(0, 50, 1, 20), Circle(5, 0, 1, 20) } }));
  EXPECT_NE(beside.find("or no part of the one lies over the other"), std::string::npos) << beside;
  const std::string between =
    JoinSentenceFor(BuildStack({ { Circle(0, 0, 1, 20), Circle(5, 0, 1, 20) },
      { Circle(5, 0, 1, 20), Circle(10, 0, 1, 20) } }));
  EXPECT_NE(between.find("other contours lie between them"), std::string::npos) << between;
}

TEST(PolyhedralSurfaceInvalid, LevelsWithoutCondition2AreNamed)
{
  // Walls a hundred thousandth apart.
  const std::vector<std::vector<Point2>> near{ Rectangle(0, 0, 1, 1),
    Rectangle(0.37, -1, 1.9, -1e-5) };
  const PolyhedralSurface surface = BuildSurface(BuildStack({ near, near }));
  int lines = 0;
  for (const std::string& line : surface.Report)
  {
    lines += line.find("On 2 levels (at offset") == 0 ? 1 : 0;
  }
  EXPECT_EQ(lines, 1);
}

TEST(PolyhedralSurfaceInvalid, ProgressRunsForwardToItsEnd)
{
  StoppingMonitor monitor(-1);
  PolyhedralOptions options;
  BuildPolyhedralSurface(BuildStack(RandomStack(2)), options, monitor);
  EXPECT_GT(monitor.Calls, 10);
  EXPECT_EQ(monitor.Backwards, 0);
  EXPECT_EQ(monitor.OutOfRange, 0);
  EXPECT_EQ(monitor.Last, 1);
}

TEST(PolyhedralSurfaceInvalid, StopsWhereverItIsAsked)
{
  // Leaks are for the sanitizer build to find; a thread that is not home would crash here.
  const ContourSet contours = BuildStack(RandomStack(3));
  for (const int threads : { 1, 2 })
  {
    PolyhedralOptions options;
    options.Threads = threads;
    StoppingMonitor whole(-1);
    const PolyhedralSurface expected = BuildPolyhedralSurface(contours, options, whole);
    std::mt19937 random(6);
    // The number of calls may vary with the threads: stay among the first half.
    std::uniform_int_distribution<int> call(1, std::max(1, whole.Calls / 2));
    for (int run = 0; run < 25; ++run)
    {
      const int stopAt = run == 0 ? 1 : call(random);
      SCOPED_TRACE("call " + std::to_string(stopAt) + " of " + std::to_string(whole.Calls));
      StoppingMonitor monitor(stopAt);
      EXPECT_THROW(BuildPolyhedralSurface(contours, options, monitor), Aborted);
      EXPECT_EQ(monitor.Calls, stopAt) << "went on after it was asked to stop";
    }
    ExpectEqualSurfaces(expected, BuildSurface(contours, options));
  }
}

TEST(PolyhedralSurfaceInvalid, StopsAtTheLastCallsToo)
{
  const ContourSet contours = BuildStack({ { Rectangle(0, 0, 1, 1) }, { Rectangle(0, 0, 1, 1) } });
  PolyhedralOptions options;
  options.Threads = 1;
  StoppingMonitor whole(-1);
  BuildPolyhedralSurface(contours, options, whole);
  for (int stopAt = 1; stopAt <= whole.Calls; ++stopAt)
  {
    SCOPED_TRACE(stopAt);
    StoppingMonitor monitor(stopAt);
    EXPECT_THROW(BuildPolyhedralSurface(contours, options, monitor), Aborted);
  }
}
