// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file BoundingBox.h
 * @brief The axis-parallel box around points of a plane (D = 2) or of space (D = 3).
 */
#ifndef recon_BoundingBox_h
#define recon_BoundingBox_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace recon
{
/**
 * @class BoundingBox
 * @brief Lowest and highest coordinates, in the units of the points; empty until a point is added.
 *
 * The empty box has Low = +infinity and High = -infinity, so that it meets and contains nothing.
 */
template <std::size_t D>
class BoundingBox
{
public:
  using Point = std::array<double, D>;

  Point Low = Filled(std::numeric_limits<double>::infinity());
  Point High = Filled(-std::numeric_limits<double>::infinity());

  BoundingBox() = default;
  BoundingBox(const Point& low, const Point& high) : Low(low), High(high) {}

  /// The box around all points of a range.
  template <typename Points>
  static BoundingBox Around(const Points& points)
  {
    BoundingBox box;
    for (const auto& p : points)
    {
      box.Add(p);
    }
    return box;
  }

  void Add(const Point& p)
  {
    for (std::size_t k = 0; k < D; ++k)
    {
      this->Low[k] = std::min(this->Low[k], p[k]);
      this->High[k] = std::max(this->High[k], p[k]);
    }
  }

  void Add(const BoundingBox& other)
  {
    for (std::size_t k = 0; k < D; ++k)
    {
      this->Low[k] = std::min(this->Low[k], other.Low[k]);
      this->High[k] = std::max(this->High[k], other.High[k]);
    }
  }

  bool IsEmpty() const { return !(this->Low[0] <= this->High[0]); }

  double Extent(std::size_t axis) const { return this->High[axis] - this->Low[axis]; }

  double LongestExtent() const
  {
    double longest = 0;
    for (std::size_t k = 0; k < D; ++k)
    {
      longest = std::max(longest, this->Extent(k));
    }
    return longest;
  }

  /// Length of the diagonal; 0 of the empty box.
  double Diagonal() const
  {
    double squared = 0;
    for (std::size_t k = 0; k < D && !this->IsEmpty(); ++k)
    {
      squared += this->Extent(k) * this->Extent(k);
    }
    return std::sqrt(squared);
  }

  Point Middle() const
  {
    Point middle{};
    for (std::size_t k = 0; k < D; ++k)
    {
      middle[k] = 0.5 * (this->Low[k] + this->High[k]);
    }
    return middle;
  }

  /// The box with a margin on all sides.
  BoundingBox Grown(double margin) const
  {
    BoundingBox grown = *this;
    for (std::size_t k = 0; k < D; ++k)
    {
      grown.Low[k] -= margin;
      grown.High[k] += margin;
    }
    return grown;
  }

  bool Contains(const Point& p) const
  {
    for (std::size_t k = 0; k < D; ++k)
    {
      if (!(this->Low[k] <= p[k] && p[k] <= this->High[k]))
      {
        return false;
      }
    }
    return true;
  }

  /// Whether the boxes have a point in common; borders count.
  bool Meets(const BoundingBox& other) const
  {
    for (std::size_t k = 0; k < D; ++k)
    {
      if (!(this->Low[k] <= other.High[k] && other.Low[k] <= this->High[k]))
      {
        return false;
      }
    }
    return true;
  }

  double SquaredDistanceTo(const Point& p) const
  {
    double sum = 0;
    for (std::size_t k = 0; k < D; ++k)
    {
      const double beside = std::max({ this->Low[k] - p[k], 0.0, p[k] - this->High[k] });
      sum += beside * beside;
    }
    return sum;
  }

private:
  static Point Filled(double value)
  {
    Point point{};
    point.fill(value);
    return point;
  }
};

using Box2 = BoundingBox<2>;
using Box3 = BoundingBox<3>;
}

#endif
