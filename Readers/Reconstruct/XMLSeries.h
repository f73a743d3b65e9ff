// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file XMLSeries.h
 * @brief A series of Reconstruct: its own file, and a file a section beside it.
 */
#ifndef recon_XMLSeries_h
#define recon_XMLSeries_h

#include "Base/Monitor.h"
#include "Common/TracedFile.h"

#include <string>

namespace recon
{
/**
 * Sections are files of the same folder, NAME.N for NAME.ser.
 *
 * @param text what is in the file
 * @throws Error where the series, or every section of it, cannot be read; Aborted
 */
TracedFile ReadXMLSeries(const std::string& fileName, const std::string& text, Monitor& monitor);
}

#endif
