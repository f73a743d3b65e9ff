// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file BoxTree.h
 * @brief Boxes of a plane in a balanced tree, searched for the one with the least of some value.
 */
#ifndef recon_BoxTree_h
#define recon_BoxTree_h

#include "Base/BoundingBox.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace recon
{
/**
 * @class BoxTree
 * @brief Branch and bound over any number of boxes. Any number of threads may search.
 */
class BoxTree
{
public:
  explicit BoxTree(const std::vector<Box2>& boxes) : Order(boxes.size()), Nodes(2 * boxes.size())
  {
    std::iota(this->Order.begin(), this->Order.end(), 0);
    if (!boxes.empty())
    {
      this->Build(boxes, 1, 0, boxes.size());
    }
  }

  struct Found
  {
    int Number = -1; ///< of a box, -1 where none is below infinity
    double Value = std::numeric_limits<double>::infinity();
  };

  /**
   * The box with the least value(number), of equals any.
   *
   * bound(box) is no greater than the value of any box inside that one; infinity leaves boxes out.
   */
  template <typename Bound, typename Value>
  Found Least(const Bound& bound, const Value& value) const
  {
    Found best;
    if (!this->Order.empty())
    {
      this->Search(1, 0, this->Order.size(), bound, value, best);
    }
    return best;
  }

private:
  /// The halves of the boxes from..to, along the longer side, become the two children of the node.
  void Build(const std::vector<Box2>& boxes, std::size_t node, std::size_t from, std::size_t to)
  {
    Box2 around;
    for (std::size_t i = from; i < to; ++i)
    {
      around.Add(boxes[static_cast<std::size_t>(this->Order[i])]);
    }
    this->Nodes[node] = around;
    if (to - from == 1)
    {
      return;
    }
    const std::size_t axis = around.Extent(0) >= around.Extent(1) ? 0 : 1;
    const std::size_t middle = from + (to - from) / 2;
    const auto begin = this->Order.begin();
    std::nth_element(begin + static_cast<std::ptrdiff_t>(from),
      begin + static_cast<std::ptrdiff_t>(middle), begin + static_cast<std::ptrdiff_t>(to),
      [&](int i, int j)
      {
        const auto key = [&](int n)
        {
          const Box2& box = boxes[static_cast<std::size_t>(n)];
          return std::make_pair(box.Low[axis] + box.High[axis], n);
        };
        return key(i) < key(j);
      });
    this->Build(boxes, node + 1, from, middle);
    this->Build(boxes, After(node, middle - from), middle, to);
  }

  /// Nodes lie in pre-order; a subtree of `count` boxes has 2 count - 1 of them.
  static std::size_t After(std::size_t node, std::size_t count) { return node + 2 * count; }

  template <typename Bound, typename Value>
  void Search(std::size_t node, std::size_t from, std::size_t to, const Bound& bound,
    const Value& value, Found& best) const
  {
    if (to - from == 1)
    {
      const double found = value(this->Order[from]);
      if (found < best.Value)
      {
        best = { this->Order[from], found };
      }
      return;
    }
    const std::size_t middle = from + (to - from) / 2;
    const std::size_t second = After(node, middle - from);
    const double bounds[2] = { bound(this->Nodes[node + 1]), bound(this->Nodes[second]) };
    const bool swapped = bounds[1] < bounds[0];
    for (const bool first : { !swapped, swapped })
    {
      if (bounds[first ? 0 : 1] < best.Value)
      {
        first ? this->Search(node + 1, from, middle, bound, value, best)
              : this->Search(second, middle, to, bound, value, best);
      }
    }
  }

  std::vector<int> Order;
  std::vector<Box2> Nodes; ///< in pre-order from 1
};
}

#endif
