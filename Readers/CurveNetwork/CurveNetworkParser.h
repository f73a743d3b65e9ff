// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file CurveNetworkParser.h
 * @brief Cross-sections with materials: .csl (CSLC) and .contour files, without VTK.
 *
 * .csl, the cross-section sets of Bermano et al. 2011:
 * @code
 * CSLC
 * nPlanes nLabels              the number of labels is unreliable and is not used
 * id nV nComp A B C D          a plane, A x + B y + C z + D = 0
 * x y z                        nV vertices
 * n label i0 ... i(n-1)        nComp rings of vertices; a hole writes its parent, an index among
 * the plane's 6h0 label i0 ... i5          rings, glued to its count
 * @endcode
 *
 * .contour, the curve networks of Liu 2008, Zou 2015 and Huang 2017:
 * @code
 * nPlanes
 * a b c d                      a plane; files disagree about the sign of d
 * nV nE
 * x y z                        nV vertices
 * i j m1 m2                    nE edges: vertices, material to the left and to the right of i to j;
 * 0 is outside
 * @endcode
 *
 * Vertices are handed on as they stand in the file, whatever its planes say; a plane that does not
 * fit is told in the report. Blank lines, any line ending and rings of any orientation are read.
 */
#ifndef recon_CurveNetworkParser_h
#define recon_CurveNetworkParser_h

#include "Base/Monitor.h"
#include "Common/ContourFile.h"

#include <string>
#include <vector>

namespace recon
{
/// The boundary of one material's region in every plane.
struct MaterialContours
{
  int Label = 0;
  LoopSoup Soup;
  std::vector<int> Planes; ///< of each chain, from 0 in the order of the file
};

struct CurveNetwork
{
  std::vector<MaterialContours> Materials; ///< by increasing label
  std::vector<std::string> Report;         ///< a sentence for everything odd that was read around
};

enum class CurveNetworkFormat
{
  None,
  CSL,
  Contour
};

/// By the file's content, whatever its name.
CurveNetworkFormat CurveNetworkFormatOf(const std::string& fileName);

/**
 * A .csl file. The rings of a component belong to its label; a hole bounds the material of the ring
 * it is cut out of, whatever label it has itself. Rings keep the orientation of the file.
 *
 * @throws Error with file, line and what was expected, where the file is not whole.
 */
CurveNetwork ReadCSL(const std::string& fileName, Monitor& monitor);

/**
 * A .contour file. The boundary of each material is walked with the material to the left, seen from
 * the tip of (a, b, c); where a network has left and right swapped, which shows by material 0 not
 * being outside, they are swapped back. Where more than two edges of a material meet, the walk
 * keeps to one corner of the material. Walks that do not close are open chains.
 *
 * @throws Error with file, line and what was expected, where the file is not whole.
 */
CurveNetwork ReadContourNetwork(const std::string& fileName, Monitor& monitor);

/// Either of them, by content.
CurveNetwork ReadCurveNetwork(const std::string& fileName, Monitor& monitor);
}

#endif
