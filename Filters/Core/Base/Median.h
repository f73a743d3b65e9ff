// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Median.h
 * @brief The one meaning of "median" in this project.
 */
#ifndef recon_Median_h
#define recon_Median_h

#include <algorithm>
#include <cstddef>
#include <vector>

namespace recon
{
/// The lower median: of an even number of values the smaller of the two in the middle, so that it
/// is always one of them. 0 of none.
inline double Median(std::vector<double> values)
{
  if (values.empty())
  {
    return 0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}
}

#endif
