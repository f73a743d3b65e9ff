// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/FaceGroups.h"

#include "Base/DisjointSets.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

namespace recon
{
namespace
{
constexpr int NoContour = -1; ///< several contours share the point
constexpr int NoGroup = -1;   ///< the face has none

/// Of every point of some levels its contour.
class ContoursOfPoints
{
public:
  ContoursOfPoints(const ContourSet& contours, const SlabRange& range)
  {
    int end = 0;
    this->ForAll(contours, range,
      [&](int, int p)
      {
        this->First = std::min(this->First, p);
        end = std::max(end, p + 1);
      });
    this->Contour.assign(static_cast<std::size_t>(std::max(0, end - this->First)), NotSeen);
    this->ForAll(contours, range,
      [&](int c, int p)
      {
        int& contour = this->Contour[p - this->First];
        contour = contour == NotSeen ? c : NoContour;
      });
  }

  int At(int point) const { return this->Contour[point - this->First]; }

private:
  static constexpr int NotSeen = -2; ///< no contour has the point

  template <typename Visit>
  static void ForAll(const ContourSet& contours, const SlabRange& range, const Visit& visit)
  {
    for (int level = range.First; level <= range.End; ++level)
    {
      for (const int c : contours.Levels[level].Contours)
      {
        for (const int p : contours.Contours[c].Points)
        {
          visit(c, p);
        }
      }
    }
  }

  int First =
    std::numeric_limits<int>::max(); ///< points of neighbouring levels have neighbouring numbers
  std::vector<int> Contour;          ///< from there on; NoContour: several share it
};

/// Of three votes, some of them for NoGroup, which is less than all: the group with most, of equals the
/// first.
int WinnerOf(std::array<int, 3> votes)
{
  std::sort(votes.begin(), votes.end());
  if (votes[1] == votes[2] || votes[1] == NoGroup)
  {
    return votes[2];
  }
  return votes[0] == NoGroup ? votes[1] : votes[0];
}

/// The same of any number of votes.
int WinnerOf(const std::map<int, int>& votes)
{
  const auto most = std::max_element(
    votes.begin(), votes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == votes.end() ? NoGroup : most->first;
}
}

std::vector<int> FindPieces(const SolidComplex& solid)
{
  DisjointSets sets(solid.Cells.size());
  for (std::size_t c = 0; c < solid.Cells.size(); ++c)
  {
    for (const int neighbour : solid.Cells[c].Neighbours)
    {
      const int n = SlabTetrahedra::Beyond(neighbour);
      // Neighbours name each other.
      if (n > static_cast<int>(c) && solid.Cells[n].Slab == solid.Cells[c].Slab)
      {
        sets.Join(static_cast<int>(c), n);
      }
    }
  }
  for (const auto& link : solid.Links)
  {
    sets.Join(link.first, link.second);
  }
  // The least cell of a set represents it, so it comes first.
  std::vector<int> pieces(solid.Cells.size());
  int count = 0;
  for (int c = 0; c < static_cast<int>(pieces.size()); ++c)
  {
    const int first = sets.Find(c);
    pieces[c] = first == c ? count++ : pieces[first];
  }
  return pieces;
}

FaceGroups::FaceGroups(const ContourSet& contours, const ContourMapping& mapping)
  : Contours(contours),
    IsEmpty(mapping.Groups.empty()),
    Below(contours.Contours.size(), NoGroup),
    Above(contours.Contours.size(), NoGroup)
{
  int number = 0;
  for (const MappingGroup& group : mapping.Groups)
  {
    for (const int c : group.LowerContours)
    {
      this->Above[c] = number;
    }
    for (const int c : group.UpperContours)
    {
      this->Below[c] = number;
    }
    ++number;
  }
}

std::vector<int> FaceGroups::Find(const std::vector<LevelState>& levels, const SolidComplex& solid,
  const SolidBoundary& boundary, const std::vector<int>& pieces) const
{
  std::vector<int> groups(boundary.Faces.size(), NoGroup);
  if (this->IsEmpty)
  {
    return groups;
  }
  const ContoursOfPoints contours(this->Contours, solid.Slabs);
  const auto groupAt = [&](int vertex, int slab)
  {
    const SolidComplex::Vertex& v = solid.Vertices[vertex];
    const int source = v.Lifted || v.Local < 0 ? -1 : levels[v.Level].Triangulation.Source[v.Local];
    const int contour = source >= 0 ? contours.At(source) : NoContour;
    if (contour == NoContour)
    {
      return NoGroup;
    }
    return v.Level == slab ? this->Above[contour] : this->Below[contour];
  };
  std::map<int, std::map<int, int>> ofPiece;
  // Faces beside one another nearly always vote for the same.
  std::pair<int, int> last{ -1, NoGroup };
  int* count = nullptr;
  for (std::size_t f = 0; f < groups.size(); ++f)
  {
    const SolidBoundary::Face& face = boundary.Faces[f];
    const int piece = pieces[face.Cell];
    std::array<int, 3> ofFace{ { NoGroup, NoGroup, NoGroup } };
    for (std::size_t k = 0; k < 3; ++k)
    {
      const SolidBoundary::Point& point = boundary.Points[face.Points[k]];
      const int group = groupAt(point.Vertex, solid.Cells[face.Cell].Slab);
      if (group == NoGroup || point.OtherVertex >= 0)
      {
        continue;
      }
      ofFace[k] = group;
      if (!count || last != std::make_pair(piece, group))
      {
        last = { piece, group };
        count = &ofPiece[piece][group];
      }
      ++*count;
    }
    groups[f] = WinnerOf(ofFace);
  }
  for (std::size_t f = 0; f < groups.size(); ++f)
  {
    if (groups[f] == NoGroup)
    {
      groups[f] = WinnerOf(ofPiece[pieces[boundary.Faces[f].Cell]]);
    }
  }
  return groups;
}
}
