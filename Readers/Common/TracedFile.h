// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file TracedFile.h
 * @brief What formats of tracing programs hold: objects with a name and a colour, each traced on
 * slices.
 */
#ifndef recon_TracedFile_h
#define recon_TracedFile_h

#include "Contours/ContourSet.h"

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace recon
{
struct TracedObject
{
  std::string Name;
  bool HasColor = false;
  std::array<unsigned char, 3> Color{};
  LoopSoup Soup;
  std::vector<int> Slices;        ///< of each chain: the number that its slice has in the file
  std::vector<std::string> Names; ///< of each chain, where traces have names of their own; or empty
};

struct TracedFile
{
  std::vector<TracedObject> Objects; ///< in the order in which the file names them first
  std::string LengthUnit;            ///< "mm", "um", "nm" ...; empty where the file tells none
  std::vector<std::string> Report;   ///< a sentence for everything odd that was read around
};

/**
 * Collects traces by the name of their object.
 *
 * Traces without a point are counted and left out, with one line for all of them; so are
 * coordinates that are no finite numbers, with their trace.
 */
class TraceCollector
{
public:
  /// The object of that name, which is cleaned first; a new one where there is none.
  TracedObject& Named(std::string_view name);
  void SetColor(TracedObject& object, const std::array<unsigned char, 3>& color);
  void Add(TracedObject& object, const std::vector<Point3>& points, bool closed, int slice,
    const std::string& name = {});
  void Say(const std::string& sentence) { this->File.Report.push_back(sentence); }
  void SetLengthUnit(const std::string& unit) { this->File.LengthUnit = unit; }

  /**
   * What was collected.
   *
   * @throws Error where there is not a single trace. The sentence begins "Cannot read FILE: ".
   */
  TracedFile Take(const std::string& fileName);

private:
  TracedFile File;
  std::map<std::string, std::size_t> Numbers; // of objects by name
  int WithoutPoints = 0;
  int NotFinite = 0;
};

/**
 * A name as it may be shown: UTF-8 as it is, other bytes taken for Latin-1, control characters as
 * spaces, none at the ends, and no longer than 200 bytes. "unnamed" where nothing is left.
 */
std::string CleanName(std::string_view bytes);
}

#endif
