// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file FieldArrays.h
 * @brief Named arrays out of containers of values, for points, cells, field data and tables.
 */
#ifndef FieldArrays_h
#define FieldArrays_h

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>

namespace recon
{
/// The array that holds values of a type: whole numbers of any width are ints, as tuples are of the
/// type of their components, and what is no number is text.
template <typename Value>
struct ArrayFor
{
  using Type = std::conditional_t<std::is_integral_v<Value>, vtkIntArray,
    std::conditional_t<std::is_floating_point_v<Value>, vtkDoubleArray, vtkStringArray>>;
  static constexpr int Components = 1;
};

template <typename Component, std::size_t Count>
struct ArrayFor<std::array<Component, Count>>
{
  using Type = std::conditional_t<std::is_same_v<Component, unsigned char>, vtkUnsignedCharArray,
    typename ArrayFor<Component>::Type>;
  static constexpr int Components = static_cast<int>(Count);
};

/// An array of that name; a value, or a tuple, is what the container holds.
template <typename Values>
auto MakeArray(const char* name, const Values& values)
{
  using Value = typename Values::value_type;
  using Array = typename ArrayFor<Value>::Type;
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(ArrayFor<Value>::Components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  vtkIdType next = 0;
  for (const auto& value : values)
  {
    if constexpr (ArrayFor<Value>::Components > 1)
    {
      array->SetTypedTuple(next++, value.data());
    }
    else if constexpr (std::is_arithmetic_v<Value>)
    {
      array->SetValue(next++, static_cast<typename Array::ValueType>(value));
    }
    else
    {
      array->SetValue(next++, value);
    }
  }
  return array;
}

/// Adds an array of that name, and takes away one that is there.
template <typename Values>
void AddArray(vtkFieldData* data, const char* name, const Values& values)
{
  data->RemoveArray(name);
  data->AddArray(MakeArray(name, values));
}

/// A value of its own, such as a figure about the whole.
template <typename Value>
void AddValue(vtkFieldData* data, const char* name, const Value& value)
{
  AddArray(data, name, std::array<Value, 1>{ value });
}

/// The text of that name; empty where there is none.
inline std::string FieldText(vtkFieldData* data, const char* name)
{
  auto* array = vtkStringArray::SafeDownCast(data->GetAbstractArray(name));
  return array && array->GetNumberOfValues() > 0 ? std::string(array->GetValue(0)) : std::string();
}
}

#endif
