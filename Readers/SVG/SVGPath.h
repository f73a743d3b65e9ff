// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SVGPath.h
 * @brief Path data and transforms of SVG as points and matrices.
 */
#ifndef recon_SVGPath_h
#define recon_SVGPath_h

#include "Base/Geometry.h"

#include <array>
#include <string>
#include <vector>

namespace recon
{
struct SVGLine
{
  std::vector<Point2> Points;
  bool Closed = false;
};

/**
 * The subpaths of a path's data (SVG 1.1, section 8.3). Curves and arcs become so many pieces that none is
 * farther from them than a thousandth of the curve's own size, and at most 64.
 *
 * @param isWhole false where the data end in something that is no path; as SVG asks, what comes before it
 * is drawn all the same
 */
std::vector<SVGLine> ParsePath(const std::string& data, bool& isWhole);

/// Numbers in a text, whatever commas and spaces are between them; it ends where something else comes.
std::vector<double> ParseNumbers(const std::string& text);

/// x' = m0 x + m2 y + m4, y' = m1 x + m3 y + m5, as in SVG's matrix().
using SVGMatrix = std::array<double, 6>;
constexpr SVGMatrix SVGIdentity{ 1, 0, 0, 1, 0, 0 };

/// Returns false where the text is no list of transforms.
bool ParseTransform(const std::string& text, SVGMatrix& matrix);
/// First inner, then outer.
SVGMatrix Compose(const SVGMatrix& outer, const SVGMatrix& inner);
Point2 Apply(const SVGMatrix& matrix, const Point2& point);

/// An ellipse as an outline.
SVGLine EllipseOutline(const Point2& centre, double radiusX, double radiusY);
}

#endif
