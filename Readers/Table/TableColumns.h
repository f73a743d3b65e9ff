// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file TableColumns.h
 * @brief The rows of a text table as words, and which column is what.
 */
#ifndef recon_TableColumns_h
#define recon_TableColumns_h

#include <string>
#include <string_view>
#include <vector>

namespace recon
{
/// What separates the columns of a line: the first of tab, semicolon, comma that is in it, or a space.
char SeparatorOf(std::string_view line);

/// The words of a line, without quotes and spaces around them. Spaces in a row are one separator.
std::vector<std::string> SplitRow(std::string_view line, char separator);

/// Numbers of the columns, -1 for those that are not there.
struct TableColumns
{
  int X = -1;
  int Y = -1;
  int Z = -1;
  int Slice = -1;
  int Contour = -1;
  int Object = -1;
  std::string LengthUnit; ///< what stands behind the names of x or y: "mm"

  /// By their names.
  static TableColumns Named(const std::vector<std::string>& names);
  /// Of a table without names, by their number.
  static TableColumns Counted(std::size_t columns);
  bool HasPlace() const { return this->X >= 0 && this->Y >= 0; }
};
}

#endif
