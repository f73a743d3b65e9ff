// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as what a structure set is written for: a DICOM image beside nothing else, or another structure set.
// What is written then can be read again, with the contour that it was given.
#include "FuzzTarget.h"

#include "DICOM/StructureSetFile.h"
#include "DICOM/StructureSetFormatter.h"
#include "Readers/Soundness.h"

#include <algorithm>

void fuzz::Try(const std::string& bytes)
{
  recon::WrittenContour contour;
  contour.Points = { { 0, 0, 5 }, { 8, 0, 5 }, { 8, 8, 5 } };
  contour.GeometricType = "CLOSED_PLANAR";
  contour.Where = "cell 0";
  recon::WrittenROI roi;
  roi.Description.Name = "fuzzed";
  roi.Contours = { contour };
  recon::StructureSetOptions options;
  options.Reference = File(bytes);
  recon::Monitor monitor;
  const std::string name = Name("written");
  RequireNone(readertesting::FaultOf(recon::WriteStructureSet(name, { roi }, options, monitor)));

  recon::StructureSetFile written(name);
  RequireNone(readertesting::FaultOf(written, monitor));
  const auto& rois = written.GetROIs();
  bool isThere = false;
  for (std::size_t i = 0; i < rois.size(); ++i)
  {
    isThere = isThere ||
      written.ReadContours(static_cast<int>(i), monitor).File.Soup.Points == contour.Points;
  }
  Require(isThere, "the contour is not in what was written");
}
