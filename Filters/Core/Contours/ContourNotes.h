// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourNotes.h
 * @brief Collects what is repaired or left out, and words it once the planes are known.
 */
#ifndef recon_ContourNotes_h
#define recon_ContourNotes_h

#include "Base/Text.h"
#include "Contours/ContourSet.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace recon
{
/**
 * A sentence for every contour that does not pass unchanged.
 *
 * Notes are taken while the common normal of the contours is still unknown, so the place is kept as
 * a point of the input and turned into an offset (or a position, where there is no common normal)
 * last.
 */
class ContourNotes
{
public:
  explicit ContourNotes(const LoopSoup& soup) : Soup(soup) {}

  /// @param sources input cells, most important first
  /// @param pointCount points of all of them together
  /// @param place index of an input point to say where, or -1 where none is usable
  /// @param what the rest of the sentence, without a full stop
  void Add(std::vector<int> sources, std::size_t pointCount, int place, const std::string& what);
  void Add(int source, std::size_t pointCount, int place, const std::string& what)
  {
    this->Add(std::vector<int>{ source }, pointCount, place, what);
  }

  /// A whole sentence that is about no contour in particular.
  void AddGeneral(const std::string& sentence) { this->General.push_back(sentence); }

  /// The sentences, general ones first, then in the order of the input cells; offsets are along the
  /// frame's normal.
  std::vector<std::string> Sentences(const std::optional<PlanarFrame>& frame) const;

private:
  struct Note
  {
    std::vector<int> Sources;
    std::size_t PointCount;
    int Place;
    std::string What;
  };
  std::string Sentence(const Note& note, const std::optional<PlanarFrame>& frame) const;

  const LoopSoup& Soup;
  std::vector<std::string> General;
  std::vector<Note> Notes;
};
}

#endif
