// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/FaceGroups.h"

#include "Base/DisjointSets.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace recon
{
namespace
{
constexpr int NoContour = -1; ///< several contours share the point
constexpr int NoGroup = -1;   ///< the face has none

/// Of every point its contour; NoContour for one that contours share.
std::vector<int> ContoursOfPoints(const ContourSet& contours)
{
  std::vector<int> contourOf(contours.Points.size(), NoContour);
  std::vector<unsigned char> seen(contours.Points.size(), 0);
  for (std::size_t c = 0; c < contours.Contours.size(); ++c)
  {
    for (const int p : contours.Contours[c].Points)
    {
      contourOf[p] = seen[p] ? NoContour : static_cast<int>(c);
      seen[p] = 1;
    }
  }
  return contourOf;
}

/// Groups by what their faces' corners say.
class GroupVotes
{
public:
  GroupVotes(const ContourSet& contours, const PolyhedralStages& stages, const SolidComplex& solid)
    : Stages(stages),
      Solid(solid),
      ContourOf(ContoursOfPoints(contours)),
      Below(contours.Contours.size(), NoGroup),
      Above(contours.Contours.size(), NoGroup)
  {
    int number = 0;
    for (const MappingGroup& group : stages.Mapping.Groups)
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

  int GroupAt(int vertex, int slab) const
  {
    const SolidComplex::Vertex& v = this->Solid.Vertices[vertex];
    if (v.Lifted || v.Local < 0)
    {
      return NoGroup;
    }
    const int source = this->Stages.Levels[v.Level].Triangulation.Source[v.Local];
    const int contour = source >= 0 ? this->ContourOf[source] : NoContour;
    if (contour == NoContour)
    {
      return NoGroup;
    }
    return v.Level == slab ? this->Above[contour] : this->Below[contour];
  }

private:
  const PolyhedralStages& Stages;
  const SolidComplex& Solid;
  std::vector<int> ContourOf;
  std::vector<int> Below; ///< of a contour: its group in the slab below its level
  std::vector<int> Above;
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

std::vector<int> FindFaceGroups(const ContourSet& contours, const PolyhedralStages& stages,
  const SolidComplex& solid, const SolidBoundary& boundary, const std::vector<int>& pieces)
{
  std::vector<int> groups(boundary.Faces.size(), NoGroup);
  if (stages.Mapping.Groups.empty())
  {
    return groups;
  }
  const GroupVotes votes(contours, stages, solid);
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
      const int group = votes.GroupAt(point.Vertex, solid.Cells[face.Cell].Slab);
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
