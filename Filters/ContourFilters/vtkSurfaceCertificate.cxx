// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSurfaceCertificate.h"

#include "Base/SubMonitor.h"
#include "ContourConversion.h"
#include "FieldArrays.h"
#include "JoinTable.h"
#include "Mesh/CertificateText.h"
#include "Mesh/MeshDefects.h"
#include "RunCore.h"
#include "SurfaceBlocks.h"
#include "SurfaceSummaries.h"
#include "vtkContourMonitor.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSurfaceCertificate);

namespace
{
constexpr double JudgingShare = 0.8; ///< of the time, beside the volume by the contours

/// One surface of the input and what was found out about it.
struct Block
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Surface; ///< triangles, and after WriteOn with its certificate
  recon::SurfaceCertificate Certificate;
  std::size_t RepairedContours = 0;
};

bool HasTrianglesOnly(vtkPolyData* surface)
{
  const bool polygonsOnly = surface->GetNumberOfVerts() == 0 && surface->GetNumberOfLines() == 0 &&
    surface->GetNumberOfStrips() == 0;
  return polygonsOnly &&
    (surface->GetNumberOfPolys() == 0 || surface->GetPolys()->IsHomogeneous() == 3);
}

vtkSmartPointer<vtkPolyData> Triangulate(vtkPolyData* surface)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  if (HasTrianglesOnly(surface))
  {
    result->ShallowCopy(surface);
    return result;
  }
  vtkNew<vtkPolyData> copy; // so that the input's pipeline stays out of it
  copy->ShallowCopy(surface);
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputData(copy);
  triangulate->PassVertsOff();
  triangulate->PassLinesOff();
  triangulate->Update();
  result->ShallowCopy(triangulate->GetOutput());
  result->GetFieldData()->ShallowCopy(surface->GetFieldData());
  return result;
}

/// What a coordinate may be off its plane by, because it was stored in single precision.
double RoundingOf(vtkPolyData* surface)
{
  if (surface->GetNumberOfPoints() == 0 || surface->GetPoints()->GetDataType() != VTK_FLOAT)
  {
    return 0;
  }
  const double* bounds = surface->GetBounds();
  const auto largest = std::max_element(
    bounds, bounds + 6, [](double a, double b) { return std::fabs(a) < std::fabs(b); });
  return FLT_EPSILON * std::fabs(*largest);
}

std::optional<recon::ContourSet> BuildContours(vtkPolyData* contours, std::size_t& repaired)
{
  if (!contours || contours->GetNumberOfCells() == 0)
  {
    return std::nullopt;
  }
  recon::ContourSetOptions options;
  options.Parallel = false;
  recon::Monitor quiet; // reading the contours takes no time worth a progress bar
  recon::ContourSet set = recon::ReadContours(contours, options, quiet);
  repaired = set.Report.size() - recon::GetReport(contours).size();
  return set;
}

std::optional<recon::VolumeInterval> VolumeOf(
  vtkPolyData* contours, const recon::ContourSet& asRead, recon::Monitor& monitor)
{
  return recon::EstimateVolume(
    recon::ToLoopSoup(contours).Soup, asRead, recon::CarriedMappingOf(contours), monitor);
}

/// A figure without meaning: NaN, or -1 for a count.
double ValueOf(const recon::CertificateFigure& figure)
{
  const bool isReal = figure.Kind == recon::CertificateFigure::Real;
  return figure.Value.value_or(isReal ? std::numeric_limits<double>::quiet_NaN() : -1);
}

vtkSmartPointer<vtkDataArray> MakeArrayFor(const recon::CertificateFigure& figure)
{
  switch (figure.Kind)
  {
    case recon::CertificateFigure::Flag:
      return vtkSmartPointer<vtkIntArray>::New();
    case recon::CertificateFigure::Count:
      return vtkSmartPointer<vtkIdTypeArray>::New();
    case recon::CertificateFigure::Real:
      break;
  }
  return vtkSmartPointer<vtkDoubleArray>::New();
}

void AddFigures(vtkPolyData* surface, const std::vector<recon::CertificateFigure>& figures)
{
  for (const auto& figure : figures)
  {
    const auto array = MakeArrayFor(figure);
    array->SetName(figure.Name.c_str());
    array->InsertNextTuple1(ValueOf(figure));
    surface->GetFieldData()->RemoveArray(figure.Name.c_str());
    surface->GetFieldData()->AddArray(array);
  }
}

template <typename Getter>
void AddSectionArray(const Block& block, const char* name, const Getter& get)
{
  std::vector<double> values;
  for (const auto& section : block.Certificate.Sections)
  {
    const std::optional<double> value = get(section);
    values.push_back(value.value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  recon::AddArray(block.Surface->GetFieldData(), name, values);
}

void AddSections(const Block& block)
{
  using recon::SectionDifference;
  AddSectionArray(block, "SectionOffset",
    [](const SectionDifference& s) { return std::optional<double>(s.Offset); });
  AddSectionArray(block, "SectionContourArea",
    [](const SectionDifference& s) { return std::optional<double>(s.ContourArea); });
  AddSectionArray(
    block, "SectionSurfaceArea", [](const SectionDifference& s) { return s.SurfaceArea; });
  AddSectionArray(
    block, "SectionDifference", [](const SectionDifference& s) { return s.SymmetricDifference; });
  AddSectionArray(block, "SectionPercent", [](const SectionDifference& s) { return s.Percent; });
}

void AddDoubts(const Block& block)
{
  std::vector<double> offsets;
  std::vector<double> widths;
  for (const recon::VolumeDoubt& doubt : block.Certificate.Drawn->Doubts)
  {
    offsets.push_back(doubt.Offset);
    widths.push_back(doubt.Width);
  }
  recon::AddArray(block.Surface->GetFieldData(), "DoubtOffset", offsets);
  recon::AddArray(block.Surface->GetFieldData(), "DoubtWidth", widths);
}

void WriteOn(const Block& block)
{
  const recon::SurfaceCertificate& certificate = block.Certificate;
  recon::AddArray(block.Surface->GetCellData(), "Defect", certificate.DefectOfTriangle);
  recon::AddArray(block.Surface->GetCellData(), "ComponentId", certificate.ComponentOfTriangle);
  const std::vector<int>& defects = certificate.DefectOfTriangle;
  if (std::any_of(defects.begin(), defects.end(),
        [](int defect) { return (defect & recon::DefectAnyError) != 0; }))
  {
    block.Surface->GetCellData()->SetActiveScalars("Defect"); // which a view colours by
  }
  AddFigures(block.Surface, recon::ListFigures(certificate.Total));
  if (!certificate.Sections.empty())
  {
    AddFigures(block.Surface, recon::ListContourFigures(certificate));
    AddSections(block);
  }
  if (certificate.Drawn)
  {
    AddDoubts(block);
  }
  auto lines = recon::ToShortText(certificate);
  if (block.RepairedContours > 0)
  {
    lines.push_back("Contours that were repaired or left out before the comparison: " +
      std::to_string(block.RepairedContours) + "; Contour Hierarchy lists them in its Report.");
  }
  recon::AddArray(block.Surface->GetFieldData(), "Certificate", lines);
  recon::AddValue(block.Surface->GetFieldData(), "CertificateJSON", recon::ToJson(certificate));
}

Block CertifyBlock(const recon::NamedPolyData& input, vtkPolyData* contours,
  recon::CertificateOptions options, recon::Monitor& monitor)
{
  Block block;
  block.Name = input.Name;
  block.Surface = Triangulate(input.Data);
  recon::TriangleMesh mesh;
  if (block.Surface->GetNumberOfPolys() > 0)
  {
    mesh = recon::ToTriangleMesh(block.Surface);
  }
  const auto set = BuildContours(contours, block.RepairedContours);
  options.CoordinateRounding = RoundingOf(input.Data);
  recon::SubMonitor judging(monitor, 0, JudgingShare);
  block.Certificate = recon::Certify(mesh, set ? &*set : nullptr, options, judging);
  if (set)
  {
    recon::SubMonitor estimating(monitor, JudgingShare, 1);
    block.Certificate.Drawn = VolumeOf(contours, *set, estimating);
  }
  WriteOn(block);
  return block;
}

/// Rows are appended to columns that the first of them makes; a table takes whole columns only.
class TableWriter
{
public:
  TableWriter(bool withBlocks, bool withContours)
    : WithBlocks(withBlocks),
      WithContours(withContours)
  {
  }

  void Add(const Block& block, const std::string& name)
  {
    const recon::SurfaceCertificate none;
    for (std::size_t c = 0; c < block.Certificate.Components.size(); ++c)
    {
      this->AddRow(name, std::to_string(c), block.Certificate.Components[c], none);
    }
    this->AddRow(name, "Total", block.Certificate.Total, block.Certificate);
  }

  void WriteTo(vtkTable* table) const
  {
    for (const auto& column : this->Columns)
    {
      table->AddColumn(column);
    }
  }

private:
  void AddRow(const std::string& block, const std::string& component,
    const recon::ComponentCertificate& certificate, const recon::SurfaceCertificate& contours)
  {
    if (this->WithBlocks)
    {
      this->AddText("Block", block);
    }
    this->AddText("Component", component);
    this->AddNumbers(recon::ListFigures(certificate));
    if (this->WithContours)
    {
      this->AddNumbers(recon::ListContourFigures(contours));
    }
  }

  vtkAbstractArray* Find(const std::string& name) const
  {
    const auto column = std::find_if(this->Columns.begin(), this->Columns.end(),
      [&](vtkAbstractArray* array) { return array->GetName() == name; });
    return column == this->Columns.end() ? nullptr : column->Get();
  }

  void Append(const std::string& name, vtkAbstractArray* column)
  {
    column->SetName(name.c_str());
    this->Columns.emplace_back(column);
  }

  void AddText(const char* name, const std::string& text)
  {
    if (!this->Find(name))
    {
      this->Append(name, vtkNew<vtkStringArray>());
    }
    vtkStringArray::SafeDownCast(this->Find(name))->InsertNextValue(text);
  }

  void AddNumbers(const std::vector<recon::CertificateFigure>& figures)
  {
    for (const auto& figure : figures)
    {
      if (!this->Find(figure.Name))
      {
        this->Append(figure.Name, MakeArrayFor(figure));
      }
      vtkDataArray::SafeDownCast(this->Find(figure.Name))->InsertNextTuple1(ValueOf(figure));
    }
  }

  std::vector<vtkSmartPointer<vtkAbstractArray>> Columns;
  bool WithBlocks;
  bool WithContours;
};

bool AreInMillimetres(const std::vector<Block>& blocks)
{
  return !blocks.empty() &&
    std::all_of(blocks.begin(), blocks.end(),
      [](const Block& block) { return recon::IsInMillimetres(block.Surface); });
}

/// A name that no other column has.
std::string ColumnName(const std::string& wanted, vtkTable* table)
{
  std::string name = wanted;
  for (int more = 2; table->GetColumnByName(name.c_str()); ++more)
  {
    name = wanted + " (" + std::to_string(more) + ")";
  }
  return name;
}

std::string NameOf(const Block& block, std::size_t number)
{
  return block.Name.empty() ? std::to_string(number) : block.Name;
}

/// The table that people read: a row a figure, a column a surface.
void FillReadingTable(
  const std::vector<Block>& blocks, bool withBlocks, bool withContours, vtkTable* table)
{
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    std::vector<std::string> figures;
    std::vector<std::string> values;
    for (auto& line :
      recon::ListLines(blocks[b].Certificate, AreInMillimetres(blocks), withContours))
    {
      figures.push_back(std::move(line.Figure));
      values.push_back(std::move(line.Value));
    }
    if (b == 0)
    {
      table->AddColumn(recon::MakeArray("(figure)", figures));
    }
    const std::string name = withBlocks ? NameOf(blocks[b], b) : "Surface";
    table->AddColumn(recon::MakeArray(ColumnName(name, table).c_str(), values));
  }
}

std::string VerdictOf(const std::vector<Block>& blocks, bool withBlocks)
{
  std::string text;
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    text += text.empty() ? "" : "\n";
    text += withBlocks ? NameOf(blocks[b], b) + ": " : "";
    text += recon::ToVerdict(blocks[b].Certificate, AreInMillimetres(blocks));
  }
  return text;
}

/// Put the certified surfaces where their originals are, in the order of ListPolyData.
void FillOutput(vtkDataObject* input, const std::vector<Block>& blocks, vtkDataObject* output)
{
  if (auto* polyData = vtkPolyData::SafeDownCast(output))
  {
    polyData->ShallowCopy(blocks.front().Surface);
    return;
  }
  auto* from = vtkDataObjectTree::SafeDownCast(input);
  auto* to = vtkDataObjectTree::SafeDownCast(output);
  to->CopyStructure(from);
  to->GetFieldData()->ShallowCopy(from->GetFieldData());
  const auto leaf = vtk::TakeSmartPointer(from->NewTreeIterator());
  std::size_t next = 0;
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    if (vtkPolyData::SafeDownCast(leaf->GetCurrentDataObject()))
    {
      to->SetDataSetFrom(leaf, blocks[next++].Surface);
    }
  }
}
}

vtkSurfaceCertificate::vtkSurfaceCertificate()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

const char* vtkSurfaceCertificate::GetVerdict()
{
  return this->Verdict.c_str();
}

void vtkSurfaceCertificate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Weld: " << (this->Weld ? "On" : "Off") << endl;
  os << indent << "Threads: " << this->Threads << endl;
}

void vtkSurfaceCertificate::SetContoursConnection(vtkAlgorithmOutput* contours)
{
  this->SetInputConnection(1, contours);
}

int vtkSurfaceCertificate::FillInputPortInformation(int port, vtkInformation* info)
{
  // Composites are taken whole, not block by block, so that surfaces and contours can be matched by
  // name.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkSurfaceCertificate::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkDataObject" : "vtkTable");
  return 1;
}

int vtkSurfaceCertificate::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  if (!input)
  {
    return 0;
  }
  vtkInformation* surfaceInfo = outputVector->GetInformationObject(0);
  vtkDataObject* output = vtkDataObject::GetData(surfaceInfo);
  if (!output || !output->IsA(input->GetClassName()))
  {
    const auto made = vtk::TakeSmartPointer(input->NewInstance());
    surfaceInfo->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  for (const int port : { 1, 2 })
  {
    vtkInformation* tableInfo = outputVector->GetInformationObject(port);
    if (!vtkTable::GetData(tableInfo))
    {
      vtkNew<vtkTable> table;
      tableInfo->Set(vtkDataObject::DATA_OBJECT(), table);
    }
  }
  return 1;
}

int vtkSurfaceCertificate::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* contours = vtkDataObject::GetData(inputVector[1]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
  vtkTable* table = vtkTable::GetData(outputVector, 1);
  vtkTable* components = vtkTable::GetData(outputVector, 2);
  this->Verdict.clear();
  return recon::RunOnAnything(this, { output, table, components },
    [&]
    {
      table->Initialize();
      components->Initialize();
      const auto surfaces = recon::ListPolyData(input);
      const auto matched = recon::MatchContours(surfaces, contours);
      recon::CertificateOptions options;
      options.Weld = this->Weld;
      options.Threads = this->Threads;
      const bool withBlocks = !vtkPolyData::SafeDownCast(input);
      TableWriter writer(withBlocks, contours != nullptr);
      std::vector<Block> blocks;
      for (std::size_t s = 0; s < surfaces.size(); ++s)
      {
        const double count = static_cast<double>(surfaces.size());
        vtkContourMonitor monitor(this, s / count, (s + 1) / count);
        blocks.push_back(CertifyBlock(surfaces[s], matched[s], options, monitor));
        writer.Add(blocks.back(), NameOf(blocks.back(), s));
      }
      FillOutput(input, blocks, output);
      FillReadingTable(blocks, withBlocks, contours != nullptr, table);
      writer.WriteTo(components);
      this->Verdict = VerdictOf(blocks, withBlocks);
    });
}
