// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file VertexRegions.h
 * @brief The regions that meet in every vertex of a level: one, or several where contours touch.
 */
#ifndef recon_VertexRegions_h
#define recon_VertexRegions_h

#include "Polyhedral/LevelTriangulation.h"

#include <algorithm>
#include <map>
#include <vector>

namespace recon
{
class VertexRegions
{
public:
  explicit VertexRegions(const LevelTriangulation& level) : First(level.Points.size(), -1)
  {
    for (std::size_t t = 0; t < level.Triangles.size(); ++t)
    {
      for (int v : level.Triangles[t])
      {
        this->Add(v, level.Region[t]);
      }
    }
  }

  template <typename Predicate>
  bool AnyOf(int vertex, Predicate predicate) const
  {
    if (this->First[vertex] < 0)
    {
      return false;
    }
    const auto more = this->More.find(vertex);
    return predicate(this->First[vertex]) ||
      (more != this->More.end() &&
        std::any_of(more->second.begin(), more->second.end(), predicate));
  }

  bool IsTouching(int vertex) const { return this->More.count(vertex) > 0; }

private:
  void Add(int vertex, int region)
  {
    if (region < 0 || region == this->First[vertex])
    {
      return;
    }
    if (this->First[vertex] < 0)
    {
      this->First[vertex] = region;
      return;
    }
    auto& more = this->More[vertex];
    if (std::find(more.begin(), more.end(), region) == more.end())
    {
      more.push_back(region);
    }
  }

  std::vector<int> First;
  std::map<int, std::vector<int>> More;
};
}

#endif
