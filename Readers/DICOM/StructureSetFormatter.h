// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file StructureSetFormatter.h
 * @brief Writes regions of interest to a DICOM RT structure set (PS3.3 A.19). No VTK.
 *
 * Coordinates are millimetres in the patient coordinate system, and pass unchanged but for rounding
 * to six decimals.
 */
#ifndef recon_StructureSetFormatter_h
#define recon_StructureSetFormatter_h

#include "Base/Geometry.h"
#include "Base/Monitor.h"
#include "DICOM/StructureSetFile.h"

#include <string>
#include <vector>

namespace recon
{
/// What every file says of itself, as its Structure Set Description (3006,0006).
constexpr const char* NoMedicalDevice =
  "Computed from drawn contours by a program that is no medical device. Not for diagnosis or "
  "treatment before a qualified person has checked and approved every contour.";

struct WrittenContour
{
  std::vector<Point3> Points; ///< of a closed one the first is not repeated
  /// Contour Geometric Type (3006,0042): POINT, OPEN_PLANAR, OPEN_NONPLANAR, CLOSED_PLANAR or
  /// CLOSEDPLANAR_XOR.
  std::string GeometricType;
  std::string Where; ///< what a sentence calls it: "cell 7"
};

/// Number 0 asks for the next free one; NumberOfContours is not looked at.
struct WrittenROI
{
  StructureSetROI Description;
  std::vector<WrittenContour> Contours;
};

struct StructureSetOptions
{
  /// An RT structure set, an image of a series, or a folder of images; empty for none.
  std::string Reference;
  bool CopyReferenceROIs = true;
  std::string Label;               ///< Structure Set Label, at most 16 characters are written
  std::string GenerationAlgorithm; ///< AUTOMATIC, SEMIAUTOMATIC, MANUAL or empty
  bool ExclusiveOr = false;        ///< closed contours as CLOSEDPLANAR_XOR instead of CLOSED_PLANAR
};

/**
 * Writes the file beside its name and then renames it, so that there is a whole file or none; one
 * that is there is replaced.
 *
 * The file has unique identifiers of its own, an implicit VR (a contour of more than some thousand
 * points does not fit the 16-bit lengths of an explicit one), and is not approved. ROIs keep their
 * numbers and names where these are free.
 *
 * @return a sentence for everything that was left out or changed
 * @throws Error where there is nothing to write, a contour cannot be written, the reference cannot
 * be used or would be overwritten, or the file cannot be written
 */
std::vector<std::string> WriteStructureSet(const std::string& fileName,
  std::vector<WrittenROI> rois, const StructureSetOptions& options, Monitor& monitor);
}

#endif
