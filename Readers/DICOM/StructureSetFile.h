// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file StructureSetFile.h
 * @brief A DICOM RT structure set: its ROIs, and the contours of those that are asked for. No VTK.
 *
 * Coordinates are millimetres in the patient coordinate system (DICOM PS3.3 C.7.6.2.1.1), as in the
 * file: no axis is swapped or flipped.
 */
#ifndef recon_StructureSetFile_h
#define recon_StructureSetFile_h

#include "Base/Monitor.h"
#include "Common/ContourFile.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace recon
{
/// A region of interest, without its contours.
struct StructureSetROI
{
  int Number = 0;
  std::string Name;      ///< UTF-8, unique in its file: "PTV (4)" where two have the name "PTV"
  std::string Type;      ///< RT ROI Interpreted Type (3006,00a4), empty where not given
  bool HasColor = false; ///< ROI Display Color (3006,002a) is optional
  std::array<int, 3> Color{ 0, 0, 0 }; ///< red, green, blue of 0 to 255
  int NumberOfContours = 0;            ///< items of its contour sequence, usable or not
  /// The frame of reference (3006,0024) that its coordinates are in; empty where the file names
  /// none. Coordinates of two frames have nothing to do with each other.
  std::string FrameOfReferenceUID;
};

/// The contours of one ROI. Closed and open ones and points are chains; what was odd is in Report.
struct StructureSetContours
{
  ContourFile File;
  /// Contour Geometric Type (3006,0042) of each chain: POINT, OPEN_PLANAR, OPEN_NONPLANAR,
  /// CLOSED_PLANAR, CLOSEDPLANAR_XOR.
  std::vector<std::string> GeometricTypes;
};

class StructureSetFile
{
public:
  /// Whether this is a DICOM file, with preamble or without, of SOP class RT Structure Set Storage.
  static bool IsStructureSet(const std::string& fileName);

  /**
   * What is wrong with one ROI costs that ROI, or only its contour, and has a line in the report.
   *
   * @throws Error with file and tag, where it is not a whole RT structure set.
   */
  explicit StructureSetFile(const std::string& fileName);
  ~StructureSetFile();
  StructureSetFile(const StructureSetFile&) = delete;
  StructureSetFile& operator=(const StructureSetFile&) = delete;

  /// In the order of the file. Those without contours are among them, and those whose number is
  /// used twice, which have none, as it is open which contours are whose.
  const std::vector<StructureSetROI>& GetROIs() const;
  /// What was odd about the file as a whole.
  const std::vector<std::string>& GetReport() const;

  /// The contours of GetROIs()[index]; progress runs from 0 to 1 within this ROI. A malformed one
  /// is left out, with a line that names ROI, contour and tag.
  StructureSetContours ReadContours(int index, Monitor& monitor);

private:
  class Internals;
  std::unique_ptr<Internals> Implementation;
};
}

#endif
