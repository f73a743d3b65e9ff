// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file RandomStacks.h
 * @brief Random nested stacks through the whole method.
 *
 * A failure names its seed; CONTOUR_STACK_SEED=<seed> in the environment runs that one alone.
 */
#ifndef recon_Testing_RandomStacks_h
#define recon_Testing_RandomStacks_h

#include "PolyhedralShapes.h"
#include "SurfaceInvariants.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace recon::testing
{
/// All options in turn, so that a range of seeds tries each.
inline void ExpectSoundStack(unsigned seed)
{
  SCOPED_TRACE("seed " + std::to_string(seed));
  ContourSet contours;
  ASSERT_NO_THROW(contours = BuildStack(RandomStack(seed)));
  if (contours.Levels.size() < 2)
  {
    return;
  }
  PolyhedralOptions options;
  options.InternalPoints = seed % 8 != 7;
  options.LiftInternalPoints = seed % 8 != 6;
  options.Threads = 1 + static_cast<int>(seed % 2);
  PolyhedralSurface surface;
  ASSERT_NO_THROW(surface = BuildSurface(contours, options));
  ExpectKeepsPromisesOrIsEmpty(surface, contours);
}

inline void ExpectSoundStacks(unsigned first, unsigned last)
{
  if (const char* only = std::getenv("CONTOUR_STACK_SEED"))
  {
    ExpectSoundStack(static_cast<unsigned>(std::atoi(only)));
    return;
  }
  for (unsigned seed = first; seed <= last; ++seed)
  {
    ExpectSoundStack(seed);
  }
}
}

#endif
