// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file CertificateText.h
 * @brief The certificate's figures by name, as JSON and as a few lines of text.
 */
#ifndef recon_CertificateText_h
#define recon_CertificateText_h

#include "Mesh/Certificate.h"

#include <optional>
#include <string>
#include <vector>

namespace recon
{
/// One figure under the name by which tables, field data and JSON know it.
struct CertificateFigure
{
  enum KindType
  {
    Flag,  ///< 0 or 1
    Count, ///< a whole number
    Real   ///< in units of the input, squared for areas, cubed for volumes; angles in degrees
  };
  std::string Name;
  KindType Kind;
  std::optional<double> Value; ///< empty where the figure has no meaning
};

/// All figures of a component or of the whole, always the same names in the same order.
std::vector<CertificateFigure> ListFigures(const ComponentCertificate& certificate);

/// The figures that only a surface with contours has; of one without, all are empty.
std::vector<CertificateFigure> ListContourFigures(const SurfaceCertificate& certificate);

/// A line of the table that people read: what, and how much of it, "-" where it has no meaning.
struct CertificateLine
{
  std::string Figure;
  std::string Value;
};

/**
 * The certificate of the whole in reading order: the verdict, what is wrong, the volume, the area,
 * then what makes the verdict, the shape, and how the contours fare. Always the same figures in the
 * same order.
 *
 * @param millimetres the unit is known to be the millimetre: volume is in cm3, area in cm2
 * @param withContours whether there are lines about contours
 */
std::vector<CertificateLine> ListLines(
  const SurfaceCertificate& certificate, bool millimetres, bool withContours);

/// "sound, 12.3 cm3", "NOT sound (3 open edges), no volume": what a region is worth in a few words.
std::string ToVerdict(const SurfaceCertificate& certificate, bool millimetres);

/**
 * Everything but what is said a triangle, as one JSON object.
 *
 * { "Total": {figures}, "Components": [{figures}], "Welded": {topology}, "Contours": {figures},
 * "Sections": [a level], "Doubts": [a VolumeDoubt] }; a figure that has no meaning is null. Numbers
 * read back to the same bits.
 */
std::string ToJson(const SurfaceCertificate& certificate);

/// A few lines for people: the verdict, what was found wrong, size and shape, and how the contours
/// fare.
std::vector<std::string> ToShortText(const SurfaceCertificate& certificate);
}

#endif
