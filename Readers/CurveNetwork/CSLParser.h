// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file CSLParser.h
 * @brief Cross-section sets (.csl) of Bermano et al. 2011, without VTK.
 *
 * @verbatim
 * CSLC
 * nPlanes nLabels          the number of labels is unreliable and is not used
 * id nV nComp A B C D      a plane, A x + B y + C z + D = 0
 * x y z                    nV vertices
 * n label i0 ... i(n-1)    nComp rings of vertices; a hole writes its parent, an index
 * 6h0 label i0 ... i5      among the plane's rings, glued to its count
 * @endverbatim
 *
 * Blank lines, any line ending and rings of any orientation are read. Its tests are among
 * TestCurveNetworkParser's, as every file comes in through that.
 */
#ifndef recon_CSLParser_h
#define recon_CSLParser_h

#include "Base/Monitor.h"
#include "CurveNetwork/CurveNetwork.h"

#include <string>

namespace recon
{
/**
 * The rings of a component belong to its label; a hole bounds the material of the ring it is cut
 * out of, whatever label it has itself. Rings keep the orientation of the file.
 *
 * @throws Error with file, line and what was expected, where the file is not whole.
 */
CurveNetwork ReadCSL(const std::string& fileName, Monitor& monitor);
}

#endif
