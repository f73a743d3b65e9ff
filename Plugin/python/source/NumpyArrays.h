// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file NumpyArrays.h
 * @brief The core's vectors as numpy arrays, without a copy, and the other way round.
 */
#ifndef NumpyArrays_h
#define NumpyArrays_h

#include "Base/Geometry.h"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace recon
{
namespace nb = nanobind;

using GivenPoints = nb::ndarray<const double, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
using GivenTriangles = nb::ndarray<const int, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
template <typename Value>
using GivenValues = nb::ndarray<const Value, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

/// How a value of a vector becomes a row of an array.
template <typename Value>
struct RowOf
{
  using Component = Value;
  static constexpr std::size_t Dimensions = 1;
  static constexpr std::size_t Count = 1;
};

template <typename Value, std::size_t Size>
struct RowOf<std::array<Value, Size>>
{
  using Component = Value;
  static constexpr std::size_t Dimensions = 2;
  static constexpr std::size_t Count = Size;
};

/// An array that owns the vector's memory: (n,), or (n, k) where a value is an array of k.
template <typename Value>
nb::object ToNumpy(std::vector<Value> values)
{
  using Row = RowOf<Value>;
  values.reserve(1); // an empty array has an address, too
  auto kept = std::make_unique<std::vector<Value>>(std::move(values));
  const std::size_t shape[2] = { kept->size(), Row::Count };
  void* data = kept->data();
  const nb::capsule owner(
    kept.release(), [](void* p) noexcept { delete static_cast<std::vector<Value>*>(p); });
  return nb::cast(
    nb::ndarray<nb::numpy, typename Row::Component>(data, Row::Dimensions, shape, owner));
}

template <typename Value>
std::vector<Value> ToVector(const GivenValues<Value>& values)
{
  return std::vector<Value>(values.data(), values.data() + values.shape(0));
}

/// Rows of three as the core's points or triangles.
template <typename Value, typename Rows>
std::vector<std::array<Value, 3>> ToRows(const Rows& rows)
{
  std::vector<std::array<Value, 3>> result(rows.shape(0));
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    const Value* row = rows.data() + 3 * i;
    result[i] = { row[0], row[1], row[2] };
  }
  return result;
}

/// What a function says of each item of a container.
template <typename Items, typename Getter>
nb::object ArrayOf(const Items& items, const Getter& valueOf)
{
  std::vector<std::decay_t<decltype(valueOf(*items.begin()))>> values;
  for (const auto& item : items)
  {
    values.push_back(valueOf(item));
  }
  return ToNumpy(std::move(values));
}
}

#endif
