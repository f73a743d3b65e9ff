// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ROIContours.h
 * @brief Lines and points as they arrive, sorted into the contours of a region of interest. No VTK.
 */
#ifndef recon_ROIContours_h
#define recon_ROIContours_h

#include "Base/Monitor.h"
#include "Contours/ContourSet.h"
#include "DICOM/StructureSetFormatter.h"

#include <string>
#include <utility>
#include <vector>

namespace recon
{
/// The lines and points of one piece of a region.
struct ROIPiece
{
  LoopSoup Soup;
  /// Contour Geometric Type of every cell (Chain::Source); shorter or empty where it is not told.
  std::vector<std::string> GeometricTypes;
  bool OnlyVertices = false;       ///< then vertices of no type are points
  std::vector<std::string> Report; ///< what was odd about the piece before
};

/**
 * @class ROIContours
 * @brief Points and open lines by their type, all else closed; in the order of the cells.
 */
class ROIContours
{
public:
  /// @param keyholes each hole is joined to what is around it by a bridge
  /// @param report takes a sentence for everything that is left out; outlives this
  ROIContours(bool keyholes, std::vector<std::string>& report, Monitor& monitor)
    : Keyholes(keyholes),
      Report(report),
      Progress(monitor)
  {
  }

  /// Appends the contours of a piece to the region that they are of.
  /// @throws Error where a line that is to be closed does not close
  void Collect(ROIPiece piece, WrittenROI& roi);

private:
  void Add(int cell, WrittenContour contour);
  void Sort(ROIPiece& piece);
  void AddClosed(const LoopSoup& closed);
  void AddKeyholes(const LoopSoup& closed, const std::string& where);

  const bool Keyholes;
  std::vector<std::string>& Report;
  Monitor& Progress;
  std::vector<std::pair<int, WrittenContour>> Contours;
};
}

#endif
