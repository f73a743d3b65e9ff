// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/DissectionOrder.h"

#include "Base/BoundingBox.h"

#include <algorithm>

namespace recon
{
namespace
{
constexpr std::size_t Leaf = 48; ///< points of a part that is not cut any further

class Dissection
{
public:
  explicit Dissection(const TriangleMesh& mesh)
    : Mesh(mesh),
      First(mesh.Points.size() + 1, 0),
      Side(mesh.Points.size(), 0)
  {
    this->Made.Rank.assign(mesh.Points.size(), -1);
    this->FindNeighbours();
  }

  DissectionOrder Order()
  {
    std::vector<int> all(this->Mesh.Points.size());
    for (std::size_t v = 0; v < all.size(); ++v)
    {
      all[v] = static_cast<int>(v);
    }
    this->Part(all, 0);
    return std::move(this->Made);
  }

private:
  void FindNeighbours()
  {
    for (const auto& t : this->Mesh.Triangles)
    {
      for (const int v : t)
      {
        this->First[v + 1] += 2;
      }
    }
    for (std::size_t v = 1; v < this->First.size(); ++v)
    {
      this->First[v] += this->First[v - 1];
    }
    std::vector<int> next = this->First;
    this->Neighbours.resize(this->First.back());
    for (const auto& t : this->Mesh.Triangles)
    {
      for (int k = 0; k < 3; ++k)
      {
        this->Neighbours[next[t[k]]++] = t[(k + 1) % 3];
        this->Neighbours[next[t[k]]++] = t[(k + 2) % 3];
      }
    }
  }

  /// Whether one of the points beside it, or beside these, which may be in no part any more, has a mark.
  bool ReachesMark(int v, int mark) const
  {
    const auto beside = [this](int w, const auto& is)
    {
      return std::any_of(this->Neighbours.begin() + this->First[w],
        this->Neighbours.begin() + this->First[w + 1], is);
    };
    const auto isMarked = [&](int w) { return this->Side[w] == mark; };
    return beside(v, [&](int w) { return isMarked(w) || beside(w, isMarked); });
  }

  int Number(const std::vector<int>& points, int depth, const std::array<int, 2>& parts)
  {
    DissectionNode node;
    node.From = this->Next;
    for (const int v : points)
    {
      this->Made.Rank[v] = this->Next++;
    }
    node.To = this->Next;
    node.Parts = parts;
    node.Depth = depth;
    const int number = static_cast<int>(this->Made.Nodes.size());
    for (const int part : parts)
    {
      if (part >= 0)
      {
        this->Made.Nodes[part].Parent = number;
      }
    }
    this->Made.Nodes.push_back(node);
    return number;
  }

  int LongestAxis(const std::vector<int>& points) const
  {
    Box3 box;
    for (const int v : points)
    {
      box.Add(this->Mesh.Points[v]);
    }
    int axis = 0;
    for (int k = 1; k < 3; ++k)
    {
      axis = box.High[k] - box.Low[k] > box.High[axis] - box.Low[axis] ? k : axis;
    }
    return axis;
  }

  /// Halves at every step, so it is a few tens of calls deep. @returns the node
  int Part(std::vector<int>& points, int depth)
  {
    if (points.size() <= Leaf)
    {
      return this->Number(points, depth, { -1, -1 });
    }
    const int axis = this->LongestAxis(points);
    std::sort(points.begin(), points.end(),
      [&](int v, int w)
      {
        const double a = this->Mesh.Points[v][axis];
        const double b = this->Mesh.Points[w][axis];
        return a != b ? a < b : v < w;
      });
    const auto half = points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2);
    std::vector<int> lower(points.begin(), half);
    std::vector<int> upper(half, points.end());
    const int mark = ++this->Marks;
    for (const int v : upper)
    {
      this->Side[v] = mark;
    }
    const auto reaching = std::stable_partition(
      lower.begin(), lower.end(), [&](int v) { return !this->ReachesMark(v, mark); });
    const std::vector<int> between(reaching, lower.end());
    lower.erase(reaching, lower.end());
    const int one = this->Part(lower, depth + 1);
    const int other = this->Part(upper, depth + 1);
    return this->Number(between, depth, { one, other });
  }

  const TriangleMesh& Mesh;
  std::vector<int> First; ///< of a point's neighbours
  std::vector<int> Neighbours;
  std::vector<int> Side; ///< the last mark of each point; marks are new in every part
  int Marks = 0;
  DissectionOrder Made;
  int Next = 0;
};
}

DissectionOrder DissectMesh(const TriangleMesh& mesh)
{
  return Dissection(mesh).Order();
}
}
