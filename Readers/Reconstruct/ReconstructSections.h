// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ReconstructSections.h
 * @brief The sections of a series, whichever file they come from, and where their traces lie.
 */
#ifndef recon_ReconstructSections_h
#define recon_ReconstructSections_h

#include "Base/Geometry.h"
#include "Base/Monitor.h"
#include "Common/TracedFile.h"
#include "Reconstruct/SectionTransform.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace recon
{
/// A trace as the file has it, and its place.
struct SectionTrace
{
  std::string Name;
  bool HasColor = false;
  std::array<unsigned char, 3> Color{};
  bool Closed = true;
  std::vector<Point2> Points;
  SectionTransform Transform;
};

struct Section
{
  double Thickness = 0;
  std::vector<SectionTrace> Traces;
};

/// By their index.
using Sections = std::map<int, Section>;

/// Places all traces; those that a transform has no place for are counted in Report.
void PlaceSections(const Sections& sections, TraceCollector& collector, Monitor& monitor);
}

#endif
