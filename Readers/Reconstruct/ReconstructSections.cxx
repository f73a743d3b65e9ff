// SPDX-License-Identifier: GPL-3.0-or-later
#include "Reconstruct/ReconstructSections.h"

#include "Base/Text.h"

namespace recon
{
namespace
{
/// Heights of the sections: that of the first is its index times its thickness; each next one is as
/// much higher as its own thickness for every index in between.
std::map<int, double> Heights(const Sections& sections)
{
  std::map<int, double> heights;
  double z = 0;
  int before = 0;
  for (const auto& [index, section] : sections)
  {
    z += (static_cast<double>(index) - before) * section.Thickness;
    heights[index] = z;
    before = index;
  }
  return heights;
}
}

void PlaceSections(const Sections& sections, TraceCollector& collector, Monitor& monitor)
{
  const std::map<int, double> heights = Heights(sections);
  std::size_t lost = 0;
  double done = 0;
  for (const auto& [index, section] : sections)
  {
    monitor.Update(done++ / static_cast<double>(sections.size()), "placing sections");
    for (const SectionTrace& trace : section.Traces)
    {
      std::vector<Point3> points;
      Point2 place{};
      bool isPlaced = true;
      for (const Point2& point : trace.Points)
      {
        isPlaced = isPlaced && trace.Transform.Place(point, place);
        points.push_back({ place[0], place[1], heights.at(index) });
      }
      lost += !isPlaced;
      if (!isPlaced)
      {
        continue;
      }
      TracedObject& object = collector.Named(trace.Name);
      if (trace.HasColor)
      {
        collector.SetColor(object, trace.Color);
      }
      collector.Add(object, points, trace.Closed, index);
    }
  }
  if (lost > 0)
  {
    collector.Say(Counted(lost, "trace") +
      " left out: the transform of the section has no place for all of their points.");
  }
}
}
