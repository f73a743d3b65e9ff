// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/ContourNotes.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace recon
{
namespace
{
// More cells than this are counted instead of named: a sentence has to stay readable.
constexpr std::size_t MaximumNamedCells = 6;
// Of a kind of note so many are named, and the rest counted.
constexpr std::size_t MaximumNamedPlaces = 3;

bool IsPartOfNumber(const std::string& text, std::size_t i)
{
  const auto isDigit = [&text](std::size_t k)
  { return k < text.size() && std::isdigit(static_cast<unsigned char>(text[k])); };
  const char c = text[i];
  const bool afterDigit = i > 0 && isDigit(i - 1);
  return isDigit(i) || (c == '.' && afterDigit && isDigit(i + 1)) || (c == '-' && isDigit(i + 1)) ||
    (c == 'e' && afterDigit) || (c == '+' && i > 0 && text[i - 1] == 'e');
}

/// The text without its numbers, and without the s of what they count.
std::string KindOf(const std::string& what)
{
  std::string kind;
  for (std::size_t i = 0; i < what.size(); ++i)
  {
    if (!IsPartOfNumber(what, i))
    {
      kind += what[i];
    }
  }
  for (const char* plural : { "points", "edges", "crossings", "contours", "were" })
  {
    const std::string word = plural;
    for (std::size_t at = kind.find(word); at != std::string::npos; at = kind.find(word))
    {
      kind.replace(at, word.size(), word == "were" ? "was" : word.substr(0, word.size() - 1));
    }
  }
  return kind;
}

/// Is a contour lost? One that is there twice is not.
bool IsLoss(const std::string& what)
{
  return what.find("left out") != std::string::npos &&
    what.find("is the same as") == std::string::npos &&
    what.find("loose segment") == std::string::npos;
}
}

void ContourNotes::Add(
  std::vector<int> sources, std::size_t pointCount, int place, const std::string& what)
{
  this->Notes.push_back({ std::move(sources), pointCount, place, what });
}

std::string ContourNotes::Name(const Note& note, const std::optional<PlanarFrame>& frame) const
{
  std::string text = note.Sources.size() == 1 ? "cell " : "cells ";
  text += Listed(note.Sources, MaximumNamedCells) + " (" + Counted(note.PointCount, "point");
  if (note.Place >= 0)
  {
    const Point3& p = this->Soup.Points[note.Place];
    text += frame ? ", at offset " + Text(frame->OffsetOf(p)) : ", near " + Text(p);
  }
  return text + ")";
}

std::string ContourNotes::Sentence(const Kind& kind, const std::optional<PlanarFrame>& frame) const
{
  const Note& first = *kind[0];
  if (kind.size() == 1)
  {
    return (first.Sources.size() == 1 ? "Contour of " : "Contours of ") + this->Name(first, frame) +
      ": " + first.What + ".";
  }
  std::vector<std::string> others;
  for (std::size_t i = 1; i < kind.size(); ++i)
  {
    others.push_back(i < MaximumNamedPlaces ? this->Name(*kind[i], frame) : std::string());
  }
  const bool single = std::all_of(
    kind.begin(), kind.end(), [](const Note* note) { return note->Sources.size() == 1; });
  return std::to_string(kind.size()) +
    (single ? " contours, the first of " : " groups of contours, the first of ") +
    this->Name(first, frame) + ": " + first.What + ". Likewise " +
    Listed(others, MaximumNamedPlaces - 1) + ".";
}

std::vector<ContourNotes::Kind> ContourNotes::Kinds() const
{
  std::vector<const Note*> order;
  for (const Note& note : this->Notes)
  {
    order.push_back(&note);
  }
  std::stable_sort(order.begin(), order.end(),
    [](const Note* a, const Note* b) { return a->Sources < b->Sources; });
  std::vector<Kind> kinds;
  std::map<std::string, std::size_t> numbers;
  for (const Note* note : order)
  {
    const auto [entry, isNew] = numbers.emplace(KindOf(note->What), kinds.size());
    if (isNew)
    {
      kinds.emplace_back();
    }
    kinds[entry->second].push_back(note);
  }
  return kinds;
}

std::vector<std::string> ContourNotes::Sentences(
  const std::optional<PlanarFrame>& frame, std::size_t kept) const
{
  std::vector<std::string> losses;
  std::vector<std::string> repairs;
  std::size_t lost = 0;
  for (const Kind& kind : this->Kinds())
  {
    const bool isLoss = IsLoss(kind[0]->What);
    (isLoss ? losses : repairs).push_back(this->Sentence(kind, frame));
    for (const Note* note : kind)
    {
      lost += isLoss ? note->Sources.size() : 0;
    }
  }
  std::vector<std::string> sentences;
  if (lost > 1 && kept > 0)
  {
    sentences.push_back(std::to_string(lost) + " contours were left out, " + std::to_string(kept) +
      (kept == 1 ? " is" : " are") + " kept.");
  }
  sentences.insert(sentences.end(), losses.begin(), losses.end());
  sentences.insert(sentences.end(), this->General.begin(), this->General.end());
  sentences.insert(sentences.end(), repairs.begin(), repairs.end());
  return sentences;
}
}
