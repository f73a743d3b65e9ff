// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file TestPaths.h
 * @brief Where tests and benchmarks find files. The folders of this machine are compiled into one source only, so that
 * a compiler cache serves every clone.
 */
#ifndef recon_TestPaths_h
#define recon_TestPaths_h

#include <string>

namespace recon::testing
{
/// A file or folder below the data of others (CONTOUR_SHARED_DATA), which may be absent; without a name all of it.
std::string SharedPath(const std::string& name = "");

/// A file or folder of this repository; without a name all of it.
std::string OwnPath(const std::string& name = "");
}

#endif
