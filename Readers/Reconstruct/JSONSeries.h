// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file JSONSeries.h
 * @brief A series of PyReconstruct: one file, of any version.
 */
#ifndef recon_JSONSeries_h
#define recon_JSONSeries_h

#include "Base/Monitor.h"
#include "Common/TracedFile.h"

#include <string>

namespace recon
{
/**
 * Sections are a list, an object by index, or, in the oldest files, NAME.N at the top.
 *
 * @param text what is in the file
 * @throws Error where the series, or every section of it, cannot be read; Aborted
 */
TracedFile ReadJSONSeries(const std::string& fileName, const std::string& text, Monitor& monitor);
}

#endif
