// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file DisjointSets.h
 * @brief Things that turn out to belong together, numbered from 0 (union-find).
 */
#ifndef recon_DisjointSets_h
#define recon_DisjointSets_h

#include <algorithm>
#include <cstddef>
#include <vector>

namespace recon
{
/// The least number represents a set, so that the order of joining does not matter.
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t count)
  {
    this->Parent.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Parent.push_back(static_cast<int>(i));
    }
  }

  int Find(int i)
  {
    while (this->At(i) != i)
    {
      this->At(i) = this->At(this->At(i));
      i = this->At(i);
    }
    return i;
  }

  void Join(int i, int j)
  {
    i = this->Find(i);
    j = this->Find(j);
    this->At(std::max(i, j)) = std::min(i, j);
  }

private:
  int& At(int i) { return this->Parent[static_cast<std::size_t>(i)]; }

  std::vector<int> Parent;
};
}

#endif
