// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/ContourNotes.h"

#include <algorithm>
#include <cstdio>

namespace recon
{
namespace
{
// More cells than this are counted instead of named: a sentence has to stay readable.
constexpr std::size_t MaximumNamedCells = 6;

std::string CellList(const std::vector<int>& sources)
{
  const std::size_t named = std::min(sources.size(), MaximumNamedCells);
  std::string text;
  for (std::size_t i = 0; i < named; ++i)
  {
    if (i > 0)
    {
      text += (i + 1 == sources.size()) ? " and " : ", ";
    }
    text += std::to_string(sources[i]);
  }
  if (named < sources.size())
  {
    text += " and " + std::to_string(sources.size() - named) + " more";
  }
  return text;
}
}

std::string ShortNumber(double value)
{
  char text[40];
  std::snprintf(text, sizeof(text), "%.6g", value);
  return text;
}

void ContourNotes::Add(
  std::vector<int> sources, std::size_t pointCount, int place, const std::string& what)
{
  this->Notes.push_back({ std::move(sources), pointCount, place, what });
}

std::string ContourNotes::Sentence(const Note& note, const std::optional<PlanarFrame>& frame) const
{
  std::string text = note.Sources.size() == 1 ? "Contour of cell " : "Contours of cells ";
  text += CellList(note.Sources) + " (" + Counted(note.PointCount, "point");
  if (note.Place >= 0)
  {
    const Point3& p = this->Soup.Points[static_cast<std::size_t>(note.Place)];
    text += frame
      ? ", at offset " + ShortNumber(frame->OffsetOf(p))
      : ", near (" + ShortNumber(p[0]) + ", " + ShortNumber(p[1]) + ", " + ShortNumber(p[2]) + ")";
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
