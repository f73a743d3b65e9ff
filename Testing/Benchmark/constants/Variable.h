// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Variable.h
 * @brief The register of constants that variables.py made variables of.
 */
#ifndef recon_Variable_h
#define recon_Variable_h

#include <array>
#include <cstddef>
#include <initializer_list>
#include <new>
#include <string>
#include <type_traits>
#include <vector>

namespace recon::variables
{
/// One constant; every one has a page of memory of its own, so that it can be told who is read.
struct Variable
{
  std::string Name; ///< file and name, with a colon between
  double Value = 0; ///< of a list: its first
  bool Whole = false;
  void* Page = nullptr;
  void (*Scale)(void* page, const void* original, double factor) = nullptr;
  std::vector<unsigned char> Original;
  volatile bool Read = false;
};

/// All that there are: one is added where the program comes by it first.
std::vector<Variable*> All();

/// Make a variable its own value times `factor`; whole numbers are rounded and never less than 1.
void Scale(Variable& variable, double factor);

/// From here on `Read` tells of each whether it has been looked at.
void Watch();

/// A page for a variable of so many bytes, registered; what it holds is written by the caller.
Variable& NewVariable(const char* file, const char* name, std::size_t bytes);
void Registered(Variable& variable);

template <typename T>
T Scaled(T value, double factor)
{
  if constexpr (std::is_integral_v<T>)
  {
    const double scaled = static_cast<double>(value) * factor;
    return scaled < 1 ? T(1) : static_cast<T>(scaled + 0.5);
  }
  else
  {
    return static_cast<T>(value * factor);
  }
}

template <typename T, std::size_t N>
void ScaleList(void* page, const void* original, double factor)
{
  for (std::size_t i = 0; i < N; ++i)
  {
    static_cast<T*>(page)[i] = Scaled(static_cast<const T*>(original)[i], factor);
  }
}

template <typename T, std::size_t N>
const std::array<T, N>& AddList(const char* file, const char* name, const T (&values)[N])
{
  Variable& variable = NewVariable(file, name, sizeof(T) * N);
  auto* kept = new (variable.Page) std::array<T, N>();
  for (std::size_t i = 0; i < N; ++i)
  {
    (*kept)[i] = values[i];
  }
  variable.Value = static_cast<double>(values[0]);
  variable.Whole = std::is_integral_v<T>;
  variable.Scale = &ScaleList<T, N>;
  Registered(variable);
  return *kept;
}

/// A structure that begins with a number: this is what is varied.
template <typename T>
const T& AddStructure(const char* file, const char* name, const T& value)
{
  Variable& variable = NewVariable(file, name, sizeof(T));
  const T* kept = new (variable.Page) T(value);
  variable.Value = *static_cast<const double*>(variable.Page);
  variable.Scale = &ScaleList<double, 1>;
  Registered(variable);
  return *kept;
}

template <typename T>
const T& Add(const char* file, const char* name, T value)
{
  const T one[1] = { value };
  return AddList<T, 1>(file, name, one)[0];
}
}

#endif
