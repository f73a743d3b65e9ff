// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ImplicitData.h
 * @brief Contours, constraints, models and surfaces of the implicit method as vtkPolyData, and
 * back.
 *
 * Everything here throws recon::Error with a sentence for the user; callers are RequestData
 * methods, which must not let it out.
 */
#ifndef ImplicitData_h
#define ImplicitData_h

#include "Implicit/Constraints/Constraints.h"
#include "Implicit/ImplicitFunction.h"
#include "Implicit/ZeroSet/Polygonizer.h"

#include <vector>

class vtkPolyData;

namespace recon
{
/// What filters behind Implicit Function need, as RunCore says it.
constexpr const char* NeedsModel = "a model as poly data: connect Implicit Function";

/// Points with vertex cells; point arrays `Value`, `Kind` (0, 1 inner, -1 outer), `ContourId`;
/// field data `MarginDistance`.
void ToPolyData(const ConstraintSet& constraints, vtkPolyData* output);

/// Points = centres, with vertex cells; point arrays `Weight`, `Value`; field data `Polynomial` (4
/// values, about `Origin`), `Origin`, `Kernel` ("Triharmonic" or "Wendland"), `SupportRadius`,
/// `Residual`, `Iterations`.
void ToPolyData(const ImplicitFunction& function, vtkPolyData* output);

/// The same way back, also from a file. @throws Error where something is missing or damaged.
[[nodiscard]] ImplicitFunction ToFunction(vtkPolyData* model);

/// Triangles with point `Normals`; field data `CellSize`, `SmallestAngle`, `FarContourPoints`.
void ToPolyData(const ImplicitMesh& mesh, vtkPolyData* output);

/// Points and the numbers of a point array. @throws Error where it is missing.
[[nodiscard]] std::vector<Point3> PointsOf(vtkPolyData* data);
[[nodiscard]] std::vector<double> NumbersOf(vtkPolyData* data, const char* array);
}

#endif
