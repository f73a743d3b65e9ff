// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file NodeDefaults.h
 * @brief Options by which the nodes join contours and end shapes, unless a user says otherwise.
 */
#ifndef recon_Testing_NodeDefaults_h
#define recon_Testing_NodeDefaults_h

#include "Fair/FairSurface.h"
#include "Polyhedral/PolyhedralOptions.h"

namespace recon::testing
{
/// Levels are not aligned, as most contours of tests stand upright.
inline PolyhedralOptions NodeOptions()
{
  PolyhedralOptions options;
  options.Mapping = PolyhedralOptions::Overlap;
  options.EndCaps = PolyhedralOptions::Tapered;
  options.IsolatedContours = PolyhedralOptions::Extrude;
  return options;
}

inline FairOptions NodeFairOptions()
{
  FairOptions options;
  options.Polyhedral = NodeOptions();
  options.Polyhedral.PinchGap = FairPinchGap;
  return options;
}
}

#endif
