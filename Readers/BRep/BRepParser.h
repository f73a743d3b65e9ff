// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file BRepParser.h
 * @brief Reads the boundary representation of the thesis's appendix (.brep), without VTK.
 *
 * @code
 * NUM_SHELL_SETS 1             # a comment runs to the end of its line, anywhere
 * BEGIN_SHELL_SET
 * NUM_SHELLS 1
 * BEGIN_SHELL
 * VERTICES 4   0 0 0  1 0 0  0 1 0  0 0 1
 * EDGES 12     0 2 2 1 1 0 ... half-edges, from vertex to vertex
 * FACES 4      0(6) 1(9) 2(3) ... three half-edges a face, the partner of each in parentheses
 * CONTOURS 1   (3) 0 1 2       ... how many half-edges, and which
 * END_SHELL
 * END_SHELL_SET
 * @endcode
 *
 * Where the grammar and its example disagree, both are read: a shell may have 0 contours. Numbers
 * count from 0. Blanks beside a parenthesis may be there or not. A number needs a digit before its
 * exponent: read to the letter, the grammar would also allow a bare "e5", which has no value.
 */
#ifndef recon_BRepParser_h
#define recon_BRepParser_h

#include "Base/Monitor.h"
#include "Mesh/BRep.h"

#include <string>

namespace recon
{
/// Whether the first word of the file, comments aside, is NUM_SHELL_SETS.
bool IsBRep(const std::string& fileName);

/**
 * The shells are free of defects (FindShellDefect).
 *
 * @throws Error with file, line and token where the text does not follow the grammar; with the
 * shell and what is wrong in it where its topology does not hold together. Aborted.
 */
BRep ReadBRep(const std::string& fileName, Monitor& monitor);
}

#endif
