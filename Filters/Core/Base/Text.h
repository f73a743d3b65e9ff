// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Text.h
 * @brief Numbers, counts and lists in sentences for the user; the one way to write them.
 */
#ifndef recon_Text_h
#define recon_Text_h

#include "Base/Geometry.h"

#include <cstddef>
#include <string>
#include <vector>

namespace recon
{
/// Six digits, as many as a user can act upon.
std::string Text(double x);

/// "(1, 2.5, 3)"
std::string Text(const Point3& p);

/// "1 contour", "2 contours"
std::string Counted(std::size_t count, const std::string& noun);

/// "3, 5 and 8"; beyond `most` of them "3, 5 and 17 more".
std::string Listed(const std::vector<std::string>& words, std::size_t most);
std::string Listed(const std::vector<int>& numbers, std::size_t most);
}

#endif
