// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/ReadReferenceSlices.h"

#include "Base/Text.h"
#include "DICOM/StructureSetReference.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace recon
{
namespace
{
/// Planes nearer than this, mm, are one: no series has slices so thin.
constexpr double SamePlane = 0.01;

/// Leaves one of several images in one plane, on which one contour would come to lie several times.
/// @param slices by increasing offset
std::size_t LeaveOutRepeated(std::vector<ReferenceSlice>& slices)
{
  std::vector<ReferenceSlice> kept;
  for (ReferenceSlice& slice : slices)
  {
    const bool isRepeated = std::any_of(kept.rbegin(), kept.rend(),
      [&slice](const ReferenceSlice& other)
      {
        return std::abs(other.Offset - slice.Offset) < SamePlane &&
          Norm(Cross(other.Normal, slice.Normal)) < 1e-6;
      });
    if (!isRepeated)
    {
      kept.push_back(std::move(slice));
    }
  }
  const std::size_t repeated = slices.size() - kept.size();
  slices = std::move(kept);
  return repeated;
}
}

SlicesOfReference ReadReferenceSlices(
  const std::string& path, const std::string& frame, Monitor& monitor)
{
  const QuietDCMTK quiet;
  const StructureSetReference reference(path, monitor);
  if (!reference.HasFrame(frame))
  {
    throw Error("Cannot take " + path + " as reference: " + reference.WhyNotIn(frame));
  }
  SlicesOfReference result;
  result.Report = reference.GetReport();
  result.FrameOfReferenceUID = reference.FrameFor(frame);
  if (frame.empty() && reference.GetFrames().size() > 1)
  {
    result.Report.push_back("The reference has several frames of reference (" +
      Listed(reference.GetFrames(), 3) + "); these are the slices of the first.");
  }
  const ReferenceSlices& known = reference.GetSlices(result.FrameOfReferenceUID);
  result.Slices = known.GetSlices();
  result.Tolerance = known.GetTolerance();
  if (result.Slices.empty())
  {
    throw Error("Cannot take " + path +
      " as reference: it does not say which image any of its contours lies on, so it tells no "
      "slices.");
  }
  std::stable_sort(result.Slices.begin(), result.Slices.end(),
    [](const ReferenceSlice& a, const ReferenceSlice& b) { return a.Offset < b.Offset; });
  const std::size_t repeated = LeaveOutRepeated(result.Slices);
  if (repeated > 0)
  {
    result.Report.push_back(Counted(repeated, "image") +
      " in the plane of another one left out, so that no contour comes to lie there twice.");
  }
  return result;
}
}
