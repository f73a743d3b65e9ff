// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/DissectionOrder.h"

#include "Base/BoundingBox.h"

#include <algorithm>

namespace recon
{
namespace
{
constexpr std::size_t Leaf = 40; ///< points of a part that is not cut any further

class Dissection
{
public:
  explicit Dissection(const TriangleMesh& mesh)
    : Mesh(mesh),
      First(mesh.Points.size() + 1, 0),
      Side(mesh.Points.size(), 0),
      Rank(mesh.Points.size(), -1)
  {
    this->FindNeighbours();
  }

  std::vector<int> Order()
  {
    std::vector<int> all(this->Mesh.Points.size());
    for (std::size_t v = 0; v < all.size(); ++v)
    {
      all[v] = static_cast<int>(v);
    }
    this->Part(all);
    return std::move(this->Rank);
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

  bool HasNeighbour(int v, int mark) const
  {
    return std::any_of(this->Neighbours.begin() + this->First[v],
      this->Neighbours.begin() + this->First[v + 1], [&](int w) { return this->Side[w] == mark; });
  }

  void Number(const std::vector<int>& points)
  {
    for (const int v : points)
    {
      this->Rank[v] = this->Next++;
    }
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

  /// Takes those of the lower half that are marked out of it.
  void TakeMarked(std::vector<int>& lower, int mark, std::vector<int>& taken)
  {
    const auto kept = std::stable_partition(
      lower.begin(), lower.end(), [&](int v) { return this->Side[v] != mark; });
    taken.insert(taken.end(), kept, lower.end());
    lower.erase(kept, lower.end());
  }

  /// Halves at every step, so it is a few tens of calls deep.
  void Part(std::vector<int>& points)
  {
    if (points.size() <= Leaf)
    {
      this->Number(points);
      return;
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
    const int up = this->Marks + 1;
    this->Marks += 3;
    for (const int v : upper)
    {
      this->Side[v] = up;
    }
    std::vector<int> between;
    for (int depth = 0; depth < 2; ++depth)
    {
      for (const int v : lower)
      {
        if (this->HasNeighbour(v, up + depth))
        {
          this->Side[v] = up + depth + 1;
        }
      }
      this->TakeMarked(lower, up + depth + 1, between);
    }
    this->Part(lower);
    this->Part(upper);
    this->Number(between);
  }

  const TriangleMesh& Mesh;
  std::vector<int> First; ///< of a point's neighbours
  std::vector<int> Neighbours;
  std::vector<int> Side; ///< the last mark of each point; marks are new in every part
  int Marks = 0;
  std::vector<int> Rank;
  int Next = 0;
};
}

std::vector<int> DissectionOrder(const TriangleMesh& mesh)
{
  return Dissection(mesh).Order();
}
}
