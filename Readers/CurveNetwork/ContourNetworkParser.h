// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourNetworkParser.h
 * @brief Curve networks (.contour) of Liu 2008, Zou 2015 and Huang 2017, without VTK.
 *
 * @verbatim
 * nPlanes
 * a b c d        a plane; files disagree about the sign of d
 * nV nE
 * x y z          nV vertices
 * i j m1 m2      nE edges: vertices, material to the left and to the right of i to j;
 *                0 is outside
 * @endverbatim
 *
 * Blank lines and any line ending are read. Its tests are among TestCurveNetworkParser's, as every
 * file comes in through that.
 */
#ifndef recon_ContourNetworkParser_h
#define recon_ContourNetworkParser_h

#include "Base/Monitor.h"
#include "CurveNetwork/CurveNetwork.h"

#include <string>

namespace recon
{
/**
 * The boundary of each material is walked with the material to the left, seen from the tip of
 * (a, b, c); where a network has left and right swapped, which shows by material 0 not being
 * outside, they are swapped back. Where more than two edges of a material meet, the walk keeps to
 * one corner of the material. Walks that do not close are open chains.
 *
 * @throws Error with file, line and what was expected, where the file is not whole.
 */
CurveNetwork ReadContourNetwork(const std::string& fileName, Monitor& monitor);
}

#endif
