// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ROIRegister.h
 * @brief Numbers and names of the ROIs of a file that is being written: each only once.
 */
#ifndef recon_ROIRegister_h
#define recon_ROIRegister_h

#include <cstddef>
#include <set>
#include <string>

namespace recon
{
/// Characters of a name (VR LO).
constexpr std::size_t LongestROIName = 64;

class ROIRegister
{
public:
  /// Those of an ROI that the file has already.
  void Take(int number, const std::string& name);

  /// One that something in the file refers to, whether it lists such an ROI or not: contours of no ROI must not become those
  /// of a new one.
  void TakeNumber(int number) { this->Numbers.insert(number); }

  /// wanted where that is free and above 0, otherwise the next after all, or the first free one where there is none.
  int NewNumber(int wanted);

  /// wanted where that is free, otherwise with a number behind it. Names that differ by the case of
  /// plain letters are one, as some planning systems do not tell them apart.
  std::string NewName(const std::string& wanted);

private:
  int FirstFree() const;

  std::set<int> Numbers;
  std::set<std::string> Names; ///< in lower case
};
}

#endif
