// SPDX-License-Identifier: GPL-3.0-or-later
#include "ImplicitData.h"

#include "ContourConversion.h"
#include "Contours/ContourSetBuilder.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>

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

template <typename Array, typename Values>
void AddPointArray(vtkPolyData* data, const char* name, const Values& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    array->SetValue(i, values[i]);
  }
  data->GetPointData()->AddArray(array);
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

ContourSet ReadContours(vtkPolyData* input, Monitor& monitor)
{
  const ConvertedLoops loops = ToLoopSoup(input);
  ContourSetOptions options;
  options.Parallel = false;
  ContourSet contours = BuildContourSet(loops.Soup, options, monitor);
  contours.Report.insert(contours.Report.begin(), loops.Report.begin(), loops.Report.end());
  return contours;
}

bool PassEmpty(vtkPolyData* input, vtkPolyData* output)
{
  if (input->GetNumberOfCells() > 0 || input->GetNumberOfPoints() > 0)
  {
    return false;
  }
  PassReport(input, { "The input is empty, so the output is." }, output);
  return true;
}

void PassReport(vtkPolyData* input, const std::vector<std::string>& lines, vtkPolyData* output)
{
  std::vector<std::string> report = GetReport(input);
  report.insert(report.end(), lines.begin(), lines.end());
  vtkFieldData* from = input->GetFieldData();
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = from->GetAbstractArray(a);
    if (array->GetName() && !output->GetFieldData()->HasArray(array->GetName()))
    {
      output->GetFieldData()->AddArray(array);
    }
  }
  SetReport(report, output);
}

void AddFieldNumbers(vtkDataObject* data, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  data->GetFieldData()->AddArray(array);
}

void ToPolyData(const ConstraintSet& constraints, vtkPolyData* output)
{
  SetPoints(constraints.Points, output);
  AddPointArray<vtkDoubleArray>(output, "Value", constraints.Values);
  AddPointArray<vtkIntArray>(output, "Kind", constraints.Kind);
  AddPointArray<vtkIntArray>(output, "ContourId", constraints.Contour);
  output->GetPointData()->SetActiveScalars("Value");
  AddFieldNumbers(output, "MarginDistance", { constraints.MarginDistance });
}

void ToPolyData(const ImplicitFunction& function, vtkPolyData* output)
{
  SetPoints(function.Centres, output);
  AddPointArray<vtkDoubleArray>(output, "Weight", function.Weights);
  AddPointArray<vtkDoubleArray>(output, "Value", function.Values);
  output->GetPointData()->SetActiveScalars("Value");
  AddFieldNumbers(output, "Polynomial", { function.Polynomial.begin(), function.Polynomial.end() });
  AddFieldNumbers(output, "Origin", { function.Origin.begin(), function.Origin.end() });
  AddFieldNumbers(output, "SupportRadius", { function.Phi.Radius });
  AddFieldNumbers(output, "Residual", { function.Residual });
  AddFieldNumbers(output, "Iterations", { static_cast<double>(function.Iterations) });
  vtkNew<vtkStringArray> kernel;
  kernel->SetName("Kernel");
  kernel->InsertNextValue(function.Phi.Kind == Kernel::Wendland ? "Wendland" : "Triharmonic");
  output->GetFieldData()->AddArray(kernel);
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
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(static_cast<vtkIdType>(mesh.Normals.size()));
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    normals->SetTuple(i, mesh.Normals[i].data());
  }
  output->GetPointData()->SetNormals(normals);
  AddFieldNumbers(output, "CellSize", { mesh.CellSize });
  AddFieldNumbers(output, "SmallestAngle", { mesh.SmallestAngle });
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
