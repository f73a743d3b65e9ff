// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ReconstructParser.h
 * @brief Series of Reconstruct (.ser and its section files) and of PyReconstruct (.jser), without VTK.
 *
 * Reconstruct (J. C. Fiala, 2005) has a series file NAME.ser and beside it a file a section, NAME.0,
 * NAME.1 ...: XML with the section's index and thickness, and traces in transforms. The polynomial
 * of a transform leads from the section's place in the series to the trace's own coordinates, so that
 * it is solved for the place here:
 *
 * @code
 * x = a0 + a1 X + a2 Y + a3 XY + a4 XX + a5 YY      a: xcoef
 * y = b0 + b1 X + b2 Y + b3 XY + b4 XX + b5 YY      b: ycoef
 * @endcode
 *
 * PyReconstruct has one JSON file, in which transforms are affine and lead to the place:
 * X = t0 x + t1 y + t2, Y = t3 x + t4 y + t5, of the series' chosen alignment.
 *
 * Coordinates are those of the series, in its unit (micrometres); z is the section's index times its
 * thickness, and where thicknesses differ the sum of those below.
 */
#ifndef recon_ReconstructParser_h
#define recon_ReconstructParser_h

#include "Base/Monitor.h"
#include "Common/TracedFile.h"

#include <string>

namespace recon
{
/// Whether the file begins as a series file of either program does.
bool IsReconstruct(const std::string& fileName);

/**
 * Either of them, by what is in the file. A section file of Reconstruct that is not there or damaged
 * is left out with a line in Report.
 *
 * @throws Error where nothing can be read; Aborted.
 */
TracedFile ReadReconstruct(const std::string& fileName, Monitor& monitor);
}

#endif
