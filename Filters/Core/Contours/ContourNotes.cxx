// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/ContourNotes.h"

#include <algorithm>

namespace recon
{
namespace
{
// More cells than this are counted instead of named: a sentence has to stay readable.
constexpr std::size_t MaximumNamedCells = 6;

}

void ContourNotes::Add(
  std::vector<int> sources, std::size_t pointCount, int place, const std::string& what)
{
  this->Notes.push_back({ std::move(sources), pointCount, place, what });
}

std::string ContourNotes::Sentence(const Note& note, const std::optional<PlanarFrame>& frame) const
{
  std::string text = note.Sources.size() == 1 ? "Contour of cell " : "Contours of cells ";
  text += Listed(note.Sources, MaximumNamedCells) + " (" + Counted(note.PointCount, "point");
  if (note.Place >= 0)
  {
    const Point3& p = this->Soup.Points[static_cast<std::size_t>(note.Place)];
    text += frame ? ", at offset " + Text(frame->OffsetOf(p)) : ", near " + Text(p);
  }
  return text + "): " + note.What + ".";
}

std::vector<std::string> ContourNotes::Sentences(const std::optional<PlanarFrame>& frame) const
{
  std::vector<const Note*> order;
  for (const Note& note : this->Notes)
  {
    order.push_back(&note);
  }
  std::stable_sort(order.begin(), order.end(),
    [](const Note* a, const Note* b) { return a->Sources < b->Sources; });
  std::vector<std::string> sentences = this->General;
  for (const Note* note : order)
  {
    sentences.push_back(this->Sentence(*note, frame));
  }
  return sentences;
}
}
