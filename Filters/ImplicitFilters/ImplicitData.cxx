// SPDX-License-Identifier: GPL-3.0-or-later
#include "ImplicitData.h"

#include "ContourConversion.h"
#include "FieldArrays.h"

#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <string>

namespace recon
{
namespace
{
/// Double precision points, each a vertex cell, so that they are seen and can be thresholded.
void SetPoints(const std::vector<Point3>& places, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(places.size()));
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(i, places[i].data());
    vertices->InsertNextCell(1, &i);
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
}

std::vector<double> FieldNumbers(vtkPolyData* model, const char* name, vtkIdType count)
{
  vtkDataArray* array = model->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfValues() != count)
  {
    throw Error(std::string("The input is no implicit function: its field data has no array ") +
      name + " of " + std::to_string(count) + " numbers; give the output of Implicit Function.");
  }
  std::vector<double> numbers;
  for (vtkIdType i = 0; i < count; ++i)
  {
    numbers.push_back(array->GetVariantValue(i).ToDouble());
  }
  return numbers;
}

Kernel::KindType KernelOf(vtkPolyData* model)
{
  vtkAbstractArray* array = model->GetFieldData()->GetAbstractArray("Kernel");
  const std::string name =
    array && array->GetNumberOfValues() == 1 ? array->GetVariantValue(0).ToString() : "";
  if (name == "Triharmonic")
  {
    return Kernel::Triharmonic;
  }
  if (name == "Wendland")
  {
    return Kernel::Wendland;
  }
  throw Error(
    "The input is no implicit function: its field data array Kernel does not say Triharmonic or "
    "Wendland; give the output of Implicit Function.");
}
}

void ToPolyData(const ConstraintSet& constraints, vtkPolyData* output)
{
  SetPoints(constraints.Points, output);
  vtkPointData* points = output->GetPointData();
  AddArray(points, "Value", constraints.Values);
  AddArray(points, "Kind", constraints.Kind);
  AddArray(points, "ContourId", constraints.Contour);
  points->SetActiveScalars("Value");
  AddValue(output->GetFieldData(), "MarginDistance", constraints.MarginDistance);
}

void ToPolyData(const ImplicitFunction& function, vtkPolyData* output)
{
  SetPoints(function.Centres, output);
  AddArray(output->GetPointData(), "Weight", function.Weights);
  AddArray(output->GetPointData(), "Value", function.Values);
  output->GetPointData()->SetActiveScalars("Value");
  vtkFieldData* model = output->GetFieldData();
  AddArray(model, "Polynomial", function.Polynomial);
  AddArray(model, "Origin", function.Origin);
  AddValue(model, "SupportRadius", function.Phi.Radius);
  AddValue(model, "Residual", function.Residual);
  AddValue(model, "Iterations", static_cast<double>(function.Iterations));
  const bool isWendland = function.Phi.Kind == Kernel::Wendland;
  AddValue(model, "Kernel", std::string(isWendland ? "Wendland" : "Triharmonic"));
}

ImplicitFunction ToFunction(vtkPolyData* model)
{
  ImplicitFunction function;
  function.Centres = PointsOf(model);
  function.Weights = NumbersOf(model, "Weight");
  function.Values = NumbersOf(model, "Value");
  const std::vector<double> polynomial = FieldNumbers(model, "Polynomial", 4);
  const std::vector<double> origin = FieldNumbers(model, "Origin", 3);
  std::copy(polynomial.begin(), polynomial.end(), function.Polynomial.begin());
  std::copy(origin.begin(), origin.end(), function.Origin.begin());
  function.Phi.Kind = KernelOf(model);
  function.Phi.Radius = FieldNumbers(model, "SupportRadius", 1).front();
  function.Residual = FieldNumbers(model, "Residual", 1).front();
  function.Validate();
  return function;
}

void ToPolyData(const ImplicitMesh& mesh, vtkPolyData* output)
{
  ToPolyData(mesh.Mesh, output);
  output->GetPointData()->SetNormals(MakeArray("Normals", mesh.Normals));
  AddValue(output->GetFieldData(), "CellSize", mesh.CellSize);
  AddValue(output->GetFieldData(), "SmallestAngle", mesh.SmallestAngle);
  AddValue(output->GetFieldData(), "FarContourPoints", static_cast<double>(mesh.FarContourPoints));
}

std::vector<Point3> PointsOf(vtkPolyData* data)
{
  std::vector<Point3> points(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetPoint(i, points[i].data());
  }
  return points;
}

std::vector<double> NumbersOf(vtkPolyData* data, const char* name)
{
  vtkDataArray* array = data->GetPointData()->GetArray(name);
  if (!array || array->GetNumberOfComponents() != 1)
  {
    throw Error(std::string("The input has no point array ") + name +
      " of one number a point: give the output of " +
      (std::string(name) == "Weight" ? "Implicit Function." : "Implicit Constraints."));
  }
  std::vector<double> numbers(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    numbers[i] = array->GetTuple1(i);
  }
  return numbers;
}
}
