// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file GivenData.h
 * @brief What Python hands over (dictionaries of arrays, and properties by name) as the core's data, and back.
 *
 * The classes that a user sees are made of these dictionaries in the package's Python files.
 */
#ifndef GivenData_h
#define GivenData_h

#include "Contours/CarriedMapping.h"
#include "Contours/ContourSetBuilder.h"
#include "Implicit/ImplicitSurface.h"
#include "Mesh/TriangleMesh.h"
#include "NumpyArrays.h"
#include "Polyhedral/PolyhedralOptions.h"

#include <nanobind/stl/string.h>

#include <optional>
#include <string>
#include <vector>

namespace recon
{
/// The value of a property, which the Python files have checked.
template <typename Value>
Value ValueOf(const nb::dict& properties, const char* name)
{
  return nb::cast<Value>(properties[name]);
}

template <typename Choice>
Choice ChoiceOf(const nb::dict& properties, const char* name)
{
  return static_cast<Choice>(ValueOf<int>(properties, name));
}

nb::list ToList(const std::vector<std::string>& lines);
std::vector<std::string> ToLines(nb::handle lines);

/// Loops as they arrive. @throws Error where the numbers do not fit together.
LoopSoup SoupOf(const nb::dict& loops);
/// points, offsets, connectivity and closed; vertices first, as poly data has them, and in order,
/// the chain that each has been.
nb::dict FromSoup(const LoopSoup& soup, std::vector<int>& order);
/// The same of clean contours, with what is known of each as cell_data and of levels as field_data.
nb::dict FromContours(const ContourSet& contours);
nb::dict LevelsOf(const ContourSet& contours);

TriangleMesh MeshOf(const GivenPoints& points, const GivenTriangles& triangles);
std::vector<std::pair<int, int>> PairsOf(const nb::dict& properties, const char* name);
/// The decisions that came with contours, if there are any.
std::optional<CarriedMapping> CarriedMappingOf(const nb::dict& loops);

ContourSetOptions ContourSetOptionsOf(const nb::dict& properties, bool parallel);
PolyhedralOptions PolyhedralOptionsOf(const nb::dict& properties);
ImplicitSurfaceOptions ImplicitSurfaceOptionsOf(const nb::dict& properties);
ConstraintOptions ConstraintOptionsOf(const nb::dict& properties);
FunctionOptions FunctionOptionsOf(const nb::dict& properties);
std::optional<Bounds> BoundsOf(const nb::dict& properties);

/// The functions of each file of bindings.
void BindContours(nb::module_& module);
void BindSurfaces(nb::module_& module);
void BindFiles(nb::module_& module);
void BindStructureSets(nb::module_& module);
void BindTraces(nb::module_& module);
}

#endif
