// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/SolidBoundary.h"

#include "Base/DisjointSets.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace recon
{
namespace
{
/// Corners of the face opposite vertex k of a positively oriented tetrahedron, seen from outside.
constexpr std::array<std::array<int, 3>, 4> OutwardFace{ { { { 1, 2, 3 } }, { { 0, 3, 2 } },
  { { 0, 1, 3 } }, { { 0, 2, 1 } } } };

class Extraction
{
public:
  explicit Extraction(const SolidComplex& solid) : Solid(solid) {}

  SolidBoundary Run()
  {
    this->CollectFaces();
    this->PairEdges();
    this->NumberPoints();
    this->Boundary.WholeFaces = static_cast<int>(this->Boundary.Faces.size());
    this->HalveSharedEdges();
    return std::move(this->Boundary);
  }

private:
  void CollectFaces()
  {
    this->FaceOf.assign(this->Solid.Cells.size(), { { -1, -1, -1, -1 } });
    for (std::size_t c = 0; c < this->Solid.Cells.size(); ++c)
    {
      const auto& cell = this->Solid.Cells[c];
      for (int k = 0; k < 4; ++k)
      {
        if (cell.Neighbours[k] != -1)
        {
          continue;
        }
        this->FaceOf[c][k] = static_cast<int>(this->Boundary.Faces.size());
        SolidBoundary::Face face{ {}, static_cast<int>(c), k };
        for (int j = 0; j < 3; ++j)
        {
          face.Points[j] = cell.Vertices[OutwardFace[k][j]];
        }
        this->Boundary.Faces.push_back(face);
      }
    }
  }

  /// Partner of edge j of a face (from its corner j to the next): 3 * face + edge of the face
  /// reached by turning around the edge through the solid. All that lies in a gap has the edge, too.
  int Turn(int face, int j) const
  {
    const auto& points = this->Boundary.Faces[face].Points;
    const int a = points[j];
    const int b = points[(j + 1) % 3];
    int cell = this->Boundary.Faces[face].Cell;
    int entered = this->Boundary.Faces[face].Opposite;
    for (;;)
    {
      const auto& vertices = this->Solid.Cells[cell].Vertices;
      int leave = 0;
      // Three of the four vertices are a, b and the one just entered opposite to.
      while (leave < 3 && (leave == entered || vertices[leave] == a || vertices[leave] == b))
      {
        ++leave;
      }
      const int next = this->Solid.Cells[cell].Neighbours[leave];
      if (next == -1)
      {
        const int other = this->FaceOf[cell][leave];
        const auto& otherPoints = this->Boundary.Faces[other].Points;
        // Seen from outside, the other face runs through the edge the other way.
        const int edge = otherPoints[0] == b ? 0 : (otherPoints[1] == b ? 1 : 2);
        return 3 * other + edge;
      }
      const bool gap = SlabTetrahedra::IsGap(next);
      const int from = gap ? SlabTetrahedra::GapTo(cell) : cell;
      cell = SlabTetrahedra::Beyond(next);
      const auto& back = this->Solid.Cells[cell].Neighbours;
      entered = static_cast<int>(std::find(back.begin(), back.end(), from) - back.begin());
    }
  }

  /// Where two faces meet in an edge they are partners; only where more do, one must turn.
  void PairEdges()
  {
    const int count = static_cast<int>(3 * this->Boundary.Faces.size());
    const auto endsOf = [this](int h)
    {
      const auto& points = this->Boundary.Faces[h / 3].Points;
      return std::minmax(points[h % 3], points[(h % 3 + 1) % 3]);
    };
    // By the lesser end, then by the other: there are few at each.
    std::vector<int> first(this->Solid.Vertices.size() + 1, 0);
    for (int h = 0; h < count; ++h)
    {
      ++first[endsOf(h).first + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::pair<int, int>> edges(count); // the other end, the half edge
    std::vector<int> next(first.begin(), first.end() - 1);
    for (int h = 0; h < count; ++h)
    {
      const auto ends = endsOf(h);
      edges[next[ends.first]++] = { ends.second, h };
    }
    this->Partner.resize(count);
    for (std::size_t v = 0; v + 1 < first.size(); ++v)
    {
      std::sort(edges.begin() + first[v], edges.begin() + first[v + 1]);
      for (int from = first[v]; from < first[v + 1];)
      {
        int to = from;
        while (to < first[v + 1] && edges[to].first == edges[from].first)
        {
          ++to;
        }
        for (int i = from; i < to; ++i)
        {
          const int h = edges[i].second;
          this->Partner[h] =
            to - from == 2 ? edges[from + to - 1 - i].second : this->Turn(h / 3, h % 3);
        }
        from = to;
      }
    }
  }

  /// Corners joined across partnered edges are one point; a vertex with several such sets is cut.
  void NumberPoints()
  {
    auto& faces = this->Boundary.Faces;
    DisjointSets sets(3 * faces.size());
    for (std::size_t h = 0; h < this->Partner.size(); ++h)
    {
      const int face = static_cast<int>(h / 3), j = static_cast<int>(h % 3);
      const int other = this->Partner[h] / 3, i = this->Partner[h] % 3;
      sets.Join(3 * face + j, 3 * other + (i + 1) % 3);
      sets.Join(3 * face + (j + 1) % 3, 3 * other + i);
    }
    std::vector<int> pointOf(3 * faces.size(), -1);
    for (std::size_t corner = 0; corner < pointOf.size(); ++corner)
    {
      const int root = sets.Find(static_cast<int>(corner));
      int& point = faces[corner / 3].Points[corner % 3];
      if (pointOf[root] < 0)
      {
        pointOf[root] = static_cast<int>(this->Boundary.Points.size());
        this->Boundary.Points.push_back({ point, -1 });
      }
      point = pointOf[root];
    }
  }

  static std::uint64_t KeyOf(int a, int b)
  {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32) |
      static_cast<std::uint32_t>(std::max(a, b));
  }

  /// Of an edge of the boundary its two ends as vertices of the solid.
  std::uint64_t VertexKeyOf(int halfEdge) const
  {
    const auto& points = this->Boundary.Faces[halfEdge / 3].Points;
    return KeyOf(this->Boundary.Points[points[halfEdge % 3]].Vertex,
      this->Boundary.Points[points[(halfEdge % 3 + 1) % 3]].Vertex);
  }

  std::uint64_t PointKeyOf(int halfEdge) const
  {
    const auto& points = this->Boundary.Faces[halfEdge / 3].Points;
    return KeyOf(points[halfEdge % 3], points[(halfEdge % 3 + 1) % 3]);
  }

  /**
   * Two wedges may still share an edge where the fans of both its ends run through both of them.
   *
   * There no cut helps; the edge of each wedge gets a point of its own in the middle. All wedges at
   * the edge are halved and not only those in the way: the middle is rounded, and faces of a wedge
   * that went on straight beside it would cross those that do not.
   */
  void HalveSharedEdges()
  {
    // By vertices: the wedges at an edge where more than two faces meet. The edges at the lesser of
    // their two vertices form a chain; there are few at each.
    std::vector<int> first(this->Solid.Vertices.size(), -1);
    std::vector<int> next(this->Partner.size(), -1);
    std::map<std::uint64_t, std::vector<int>> wedges;
    for (std::size_t i = 0; i < this->Partner.size(); ++i)
    {
      const int h = static_cast<int>(i);
      if (h > this->Partner[i])
      {
        continue;
      }
      const std::uint64_t key = this->VertexKeyOf(h);
      int& begin = first[key >> 32];
      int known = begin;
      while (known >= 0 && this->VertexKeyOf(known) != key)
      {
        known = next[known];
      }
      if (known < 0)
      {
        next[i] = begin;
        begin = h;
        continue;
      }
      auto& here = wedges[key];
      if (here.empty())
      {
        here.push_back(known);
      }
      here.push_back(h);
    }
    std::vector<int> halve;
    for (const auto& entry : wedges)
    {
      std::vector<std::uint64_t> keys;
      for (int h : entry.second)
      {
        keys.push_back(this->PointKeyOf(h));
      }
      std::sort(keys.begin(), keys.end());
      if (std::adjacent_find(keys.begin(), keys.end()) != keys.end())
      {
        halve.insert(halve.end(), entry.second.begin(), entry.second.end());
      }
    }
    this->InsertMiddles(halve);
  }

  void InsertMiddles(const std::vector<int>& halve)
  {
    // Of every edge of the affected faces its middle point; each face is then cut into a fan.
    std::unordered_map<int, std::array<int, 3>> middles;
    for (int h : halve)
    {
      const auto& points = this->Boundary.Faces[h / 3].Points;
      const int v = this->Boundary.Points[points[h % 3]].Vertex;
      const int w = this->Boundary.Points[points[(h % 3 + 1) % 3]].Vertex;
      const int middle = static_cast<int>(this->Boundary.Points.size());
      this->Boundary.Points.push_back({ v, w });
      for (int side : { h, this->Partner[h] })
      {
        middles.emplace(side / 3, std::array<int, 3>{ { -1, -1, -1 } }).first->second[side % 3] =
          middle;
      }
    }
    std::vector<std::pair<int, std::array<int, 3>>> ordered(middles.begin(), middles.end());
    std::sort(ordered.begin(), ordered.end());
    for (const auto& entry : ordered)
    {
      this->SplitFace(entry.first, entry.second);
    }
  }

  void SplitFace(int face, const std::array<int, 3>& middles)
  {
    const SolidBoundary::Face whole = this->Boundary.Faces[face];
    std::vector<int> polygon;
    int apex = -1;
    for (int j = 0; j < 3; ++j)
    {
      polygon.push_back(whole.Points[j]);
      if (middles[j] >= 0)
      {
        apex = apex < 0 ? static_cast<int>(polygon.size()) : apex;
        polygon.push_back(middles[j]);
      }
    }
    // A fan from a middle has no flat triangle: no two of its edges lie on one edge of the face.
    const int size = static_cast<int>(polygon.size());
    for (int i = 1; i + 1 < size; ++i)
    {
      const SolidBoundary::Face piece{
        { { polygon[apex], polygon[(apex + i) % size], polygon[(apex + i + 1) % size] } },
        whole.Cell, whole.Opposite
      };
      if (i == 1)
      {
        this->Boundary.Faces[face] = piece;
      }
      else
      {
        this->Boundary.Faces.push_back(piece);
      }
    }
    this->Boundary.Splits.push_back(
      { face, whole.Points, static_cast<int>(this->Boundary.Faces.size()) });
  }

  const SolidComplex& Solid;
  SolidBoundary Boundary;
  std::vector<std::array<int, 4>> FaceOf; ///< of a cell's faces the number on the boundary, or -1
  std::vector<int> Partner;
};
}

SolidBoundary ExtractSolidBoundary(const SolidComplex& solid)
{
  return Extraction(solid).Run();
}
}
