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

/**
 * Everything but what is said a triangle, as one JSON object.
 *
 * { "Total": {figures}, "Components": [{figures}], "Welded": {topology}, "Contours": {figures},
 * "Sections": [a level] }; a figure that has no meaning is null. Numbers read back to the same
 * bits.
 */
std::string ToJson(const SurfaceCertificate& certificate);

/// A few lines for people: the verdict, what was found wrong, size and shape, and how the contours
/// fare.
std::vector<std::string> ToShortText(const SurfaceCertificate& certificate);
}

#endif
