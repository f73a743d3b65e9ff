// SPDX-License-Identifier: GPL-3.0-or-later
#include "ContourConversion.h"

#include "Base/Monitor.h"
#include "FieldArrays.h"
#include "SurfaceTest.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <limits>

namespace recon
{
namespace
{
std::vector<Point3> ConvertPoints(vtkPolyData* input)
{
  const vtkIdType count = input->GetNumberOfPoints();
  if (count > std::numeric_limits<int>::max())
  {
    throw Error("The input has " + std::to_string(count) + " points, more than the " +
      std::to_string(std::numeric_limits<int>::max()) + " that can be numbered: split it.");
  }
  std::vector<Point3> points(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    input->GetPoint(i, points[static_cast<std::size_t>(i)].data());
  }
  return points;
}

LoopSoup::Chain MakeChain(vtkIdType count, const vtkIdType* ids, bool closed, int source)
{
  LoopSoup::Chain chain;
  chain.Closed = closed;
  chain.Source = source;
  // A last point with the first one's index closes a polyline; it is not a point of its own.
  if (!closed && count > 2 && ids[0] == ids[count - 1])
  {
    chain.Closed = true;
    --count;
  }
  chain.Points.reserve(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    chain.Points.push_back(static_cast<int>(ids[i]));
  }
  return chain;
}

/// Appends a chain a cell; source runs on as cell numbers of vtkPolyData do.
void AppendChains(vtkCellArray* cells, bool closed, int& source, LoopSoup& soup)
{
  const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(count, ids);
    soup.Chains.push_back(MakeChain(count, ids, closed, source++));
  }
}

/// What the cells' `GeometricType`, as DICOM readers give it, tells: which are defined by even-odd,
/// and the unit.
void MarkTypes(vtkPolyData* input, LoopSoup& soup)
{
  auto* types =
    vtkStringArray::SafeDownCast(input->GetCellData()->GetAbstractArray("GeometricType"));
  if (!types)
  {
    return;
  }
  // DICOM has such types, and its unit is the millimetre; other files that have them tell theirs.
  auto* unit = vtkStringArray::SafeDownCast(input->GetFieldData()->GetAbstractArray("LengthUnit"));
  soup.Millimetres = !unit || (unit->GetNumberOfValues() > 0 && unit->GetValue(0) == "mm");
  for (LoopSoup::Chain& chain : soup.Chains)
  {
    chain.ExclusiveOr = chain.Source < types->GetNumberOfValues() &&
      types->GetValue(chain.Source) == "CLOSEDPLANAR_XOR";
  }
}

/// Levels that Contour Hierarchy, or a filter after it, found and wrote.
void MarkLevels(vtkPolyData* input, LoopSoup& soup)
{
  vtkFieldData* field = input->GetFieldData();
  vtkDataArray* level = input->GetCellData()->GetArray("Level");
  vtkDataArray* normal = field->GetArray("LevelNormal");
  vtkDataArray* offset = field->GetArray("LevelOffset");
  vtkDataArray* thickness = field->GetArray("LevelThickness");
  if (!level || !normal || !offset || !thickness || normal->GetNumberOfComponents() != 3 ||
    normal->GetNumberOfTuples() != offset->GetNumberOfTuples() ||
    thickness->GetNumberOfTuples() != offset->GetNumberOfTuples())
  {
    return;
  }
  for (vtkIdType l = 0; l < offset->GetNumberOfTuples(); ++l)
  {
    LoopSoup::KnownLevel known;
    normal->GetTuple(l, known.Normal.data());
    known.Offset = offset->GetComponent(l, 0);
    known.Thickness = thickness->GetComponent(l, 0);
    soup.Levels.push_back(known);
  }
  for (LoopSoup::Chain& chain : soup.Chains)
  {
    chain.Level = static_cast<int>(level->GetComponent(chain.Source, 0));
  }
}

/// One chain a vertex, also where a cell holds many of them.
void AppendVertices(vtkCellArray* cells, int& source, LoopSoup& soup)
{
  const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(count, ids);
    for (vtkIdType i = 0; i < count; ++i)
    {
      soup.Chains.push_back(MakeChain(1, ids + i, false, source));
    }
    ++source;
  }
}

vtkSmartPointer<vtkPoints> MakePoints(const std::vector<Point3>& from)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(from.size()));
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), from[i].data());
  }
  return points;
}

/// A cell array of what a function says of every contour.
template <typename Getter>
void AddContourArray(
  const ContourSet& set, const char* name, const Getter& valueOf, vtkPolyData* output)
{
  std::vector<decltype(valueOf(set.Contours.front()))> values;
  for (const Contour& contour : set.Contours)
  {
    values.push_back(valueOf(contour));
  }
  AddArray(output->GetCellData(), name, values);
}

void AddContourArrays(const ContourSet& set, vtkPolyData* output)
{
  int id = 0;
  AddContourArray(
    set, "Level", [](const Contour& c) { return c.Level; }, output);
  AddContourArray(
    set, "ContourId", [&id](const Contour&) { return id++; }, output);
  AddContourArray(
    set, "Depth", [](const Contour& c) { return c.Depth; }, output);
  AddContourArray(
    set, "Parent", [](const Contour& c) { return c.Parent; }, output);
  AddContourArray(
    set, "SignedArea", [](const Contour& c) { return c.SignedArea; }, output);
}
}

ConvertedLoops ToLoopSoup(vtkPolyData* input)
{
  if (!input || input->GetNumberOfPoints() == 0)
  {
    throw Error("The input has no points: give contours as polylines, polygons or line segments.");
  }
  ConvertedLoops loops;
  loops.Soup.Points = ConvertPoints(input);
  int source = 0;
  AppendVertices(input->GetVerts(), source, loops.Soup);
  AppendChains(input->GetLines(), false, source, loops.Soup);
  AppendChains(input->GetPolys(), true, source, loops.Soup);
  MarkTypes(input, loops.Soup);
  MarkLevels(input, loops.Soup);
  const vtkIdType strips = input->GetNumberOfStrips();
  if (strips > 0)
  {
    loops.Report.push_back(std::to_string(strips) +
      (strips == 1 ? " triangle strip is" : " triangle strips are") + " no contour and " +
      (strips == 1 ? "was" : "were") + " left aside.");
  }
  if (loops.Soup.Chains.empty())
  {
    throw Error(strips > 0 ? SurfaceSentence
                           : "The input has points but no cells: give contours as polylines, "
                             "polygons or line segments.");
  }
  return loops;
}

ContourSet ReadContours(vtkPolyData* input, const ContourSetOptions& options, Monitor& monitor)
{
  const ConvertedLoops loops = ToLoopSoup(input);
  if (IsSurface(input))
  {
    throw Error(SurfaceSentence);
  }
  ContourSet contours = BuildContourSet(loops.Soup, options, monitor);
  std::vector<std::string> report = GetReport(input);
  report.insert(report.end(), loops.Report.begin(), loops.Report.end());
  contours.Report.insert(contours.Report.begin(), report.begin(), report.end());
  return contours;
}

std::vector<int> ToPolyData(const LoopSoup& soup, vtkPolyData* output)
{
  output->Initialize();
  output->SetPoints(MakePoints(soup.Points));
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkCellArray> lines;
  std::vector<int> chains;
  std::vector<int> lineChains;
  for (std::size_t c = 0; c < soup.Chains.size(); ++c)
  {
    const LoopSoup::Chain& chain = soup.Chains[c];
    const bool isPoint = chain.Points.size() == 1;
    const bool repeatsFirst = !isPoint && chain.Closed;
    vtkCellArray* cells = isPoint ? vertices.Get() : lines.Get();
    cells->InsertNextCell(static_cast<int>(chain.Points.size()) + (repeatsFirst ? 1 : 0));
    for (int p : chain.Points)
    {
      cells->InsertCellPoint(p);
    }
    if (repeatsFirst)
    {
      cells->InsertCellPoint(chain.Points.front());
    }
    (isPoint ? chains : lineChains).push_back(static_cast<int>(c));
  }
  output->SetVerts(vertices);
  output->SetLines(lines);
  chains.insert(chains.end(), lineChains.begin(), lineChains.end());
  return chains;
}

void ToPolyData(const ContourSet& set, vtkPolyData* output)
{
  output->Initialize();
  output->SetPoints(MakePoints(set.Points));
  vtkNew<vtkCellArray> lines;
  for (const Contour& contour : set.Contours)
  {
    lines->InsertNextCell(static_cast<int>(contour.Points.size()) + 1);
    for (int p : contour.Points)
    {
      lines->InsertCellPoint(p);
    }
    lines->InsertCellPoint(contour.Points.front());
  }
  output->SetLines(lines);
  AddContourArrays(set, output);
  AddLevels(set, output);
  std::vector<std::string> holes;
  for (const Level& level : set.Levels)
  {
    holes.push_back(level.HoleNote);
  }
  AddArray(output->GetFieldData(), "LevelHoleRule", holes);
}

void PassCellData(const ContourSet& set, vtkPolyData* input, vtkPolyData* output)
{
  vtkCellData* from = input->GetCellData();
  vtkCellData* to = output->GetCellData();
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = from->GetAbstractArray(a);
    if (!array->GetName() || to->HasArray(array->GetName()))
    {
      continue;
    }
    const auto copy = vtk::TakeSmartPointer(array->NewInstance());
    copy->SetName(array->GetName());
    copy->SetNumberOfComponents(array->GetNumberOfComponents());
    copy->SetNumberOfTuples(static_cast<vtkIdType>(set.Contours.size()));
    for (std::size_t c = 0; c < set.Contours.size(); ++c)
    {
      copy->SetTuple(static_cast<vtkIdType>(c), set.Contours[c].Source, array);
    }
    to->AddArray(copy);
  }
}

void AddLevels(const ContourSet& set, vtkDataObject* output)
{
  std::vector<Vector3> normals;
  std::vector<double> offsets;
  std::vector<double> thicknesses;
  for (const Level& level : set.Levels)
  {
    normals.push_back(level.Frame.Normal);
    offsets.push_back(level.Offset);
    thicknesses.push_back(level.Thickness);
  }
  AddArray(output->GetFieldData(), "LevelNormal", normals);
  AddArray(output->GetFieldData(), "LevelOffset", offsets);
  AddArray(output->GetFieldData(), "LevelThickness", thicknesses);
}

void ToPolyData(const TriangleMesh& mesh, vtkPolyData* output)
{
  output->Initialize();
  output->SetPoints(MakePoints(mesh.Points));
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(static_cast<vtkIdType>(mesh.Triangles.size()),
    3 * static_cast<vtkIdType>(mesh.Triangles.size()));
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    const vtkIdType ids[3] = { t[0], t[1], t[2] };
    triangles->InsertNextCell(3, ids);
  }
  output->SetPolys(triangles);
}

TriangleMesh ToTriangleMesh(vtkPolyData* input)
{
  if (!input || input->GetNumberOfPolys() == 0)
  {
    throw Error(input && input->GetNumberOfStrips() > 0
        ? "The surface has triangle strips only: apply Triangulate first."
        : "The surface has no triangles.");
  }
  if (input->GetNumberOfStrips() > 0)
  {
    throw Error("The surface has triangle strips: apply Triangulate first.");
  }
  TriangleMesh mesh;
  mesh.Points = ConvertPoints(input);
  mesh.Triangles.reserve(static_cast<std::size_t>(input->GetNumberOfPolys()));
  const auto cell = vtk::TakeSmartPointer(input->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(count, ids);
    if (count != 3)
    {
      throw Error("Polygon " + std::to_string(cell->GetCurrentCellId()) + " of the surface has " +
        std::to_string(count) + " corners instead of 3: apply Triangulate first.");
    }
    mesh.Triangles.push_back(
      { static_cast<int>(ids[0]), static_cast<int>(ids[1]), static_cast<int>(ids[2]) });
  }
  return mesh;
}

void SetReport(const std::vector<std::string>& lines, vtkDataObject* data)
{
  data->GetFieldData()->RemoveArray("Report");
  if (!lines.empty())
  {
    AddArray(data->GetFieldData(), "Report", lines);
  }
}

std::vector<std::string> GetReport(vtkDataObject* data)
{
  std::vector<std::string> lines;
  const auto* array =
    vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("Report"));
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    lines.push_back(const_cast<vtkStringArray*>(array)->GetValue(i));
  }
  return lines;
}

std::vector<std::string> JoinReports(vtkDataObject* input, const std::vector<std::string>& lines)
{
  std::vector<std::string> joined = GetReport(input);
  joined.insert(joined.end(), lines.begin(), lines.end());
  return joined;
}
}
