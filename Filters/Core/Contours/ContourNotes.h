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
 * What happened to every contour that does not pass unchanged, one sentence a kind.
 *
 * Notes are taken while the common normal of the contours is still unknown, so the place is kept as
 * a point of the input and turned into an offset (or a position, where there is no common normal)
 * last. Notes that differ in numbers only are of one kind.
 */
class ContourNotes
{
public:
  explicit ContourNotes(const LoopSoup& soup) : Soup(soup) {}

  /// @param sources input cells, most important first
  /// @param pointCount points of all of them together
  /// @param place index of an input point to say where, or -1 where none is usable
  /// @param what the rest of the sentence, without a full stop; it has "left out" where the contour
  /// is lost
  void Add(std::vector<int> sources, std::size_t pointCount, int place, const std::string& what);
  void Add(int source, std::size_t pointCount, int place, const std::string& what)
  {
    this->Add(std::vector<int>{ source }, pointCount, place, what);
  }

  /// A whole sentence that is about no contour in particular.
  void AddGeneral(const std::string& sentence) { this->General.push_back(sentence); }

  /// What follows from the last such sentence, on the same line; a line of its own where there is
  /// none.
  void ContinueGeneral(const std::string& sentence)
  {
    if (this->General.empty())
    {
      this->General.push_back(sentence);
      return;
    }
    this->General.back() += " " + sentence;
  }

  /**
   * The sentences, the important first: how many contours were lost, where it is more than one, then
   * what was lost, general sentences, and what was repaired; in the order of input cells.
   *
   * A kind of which there are several is one sentence with their number and the first three places.
   * Offsets are along the frame's normal.
   *
   * @param kept contours that are left
   */
  std::vector<std::string> Sentences(
    const std::optional<PlanarFrame>& frame, std::size_t kept) const;

private:
  struct Note
  {
    std::vector<int> Sources;
    std::size_t PointCount;
    int Place;
    std::string What;
  };
  using Kind = std::vector<const Note*>;

  std::vector<Kind> Kinds() const;
  std::string Sentence(const Kind& kind, const std::optional<PlanarFrame>& frame) const;
  /// "cell 4 (12 points, at offset 3)"
  std::string Name(const Note& note, const std::optional<PlanarFrame>& frame) const;

  const LoopSoup& Soup;
  std::vector<std::string> General;
  std::vector<Note> Notes;
};
}

#endif
