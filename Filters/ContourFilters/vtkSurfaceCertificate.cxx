// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSurfaceCertificate.h"

#include "Base/SubMonitor.h"
#include "CertificateTables.h"
#include "ContourConversion.h"
#include "FieldArrays.h"
#include "JoinTable.h"
#include "Mesh/MeshDefects.h"
#include "Pieces.h"
#include "Ranks.h"
#include "RunCore.h"
#include "SurfaceBlocks.h"
#include "SurfaceSummaries.h"
#include "vtkContourMonitor.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <exception>
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
  int Number = 0;                       ///< among those of all ranks
  bool IsOwn = true;                    ///< or another rank judges it
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
  if (!contours || contours->GetNumberOfCells() == 0 || !recon::NothingOf(contours).empty())
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

void AddFigures(vtkPolyData* surface, const std::vector<recon::CertificateFigure>& figures)
{
  for (const auto& figure : figures)
  {
    const auto array = recon::MakeArrayFor(figure);
    array->SetName(figure.Name.c_str());
    array->InsertNextTuple1(recon::ValueOf(figure));
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

Block CertifyBlock(const recon::NamedPolyData& input, recon::BlockPlace place,
  vtkPolyData* contours, recon::CertificateOptions options, recon::Monitor& monitor)
{
  Block block;
  block.Name = input.Name;
  block.Number = place.Number;
  block.IsOwn = place.IsOwn;
  block.Surface = Triangulate(input.Data);
  if (!block.IsOwn)
  {
    return block;
  }
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

/// Whether the blocks that ranks have, all of them, are in millimetres.
bool AreInMillimetres(const std::vector<Block>& blocks, const recon::Ranks& ranks)
{
  const bool all = std::all_of(blocks.begin(), blocks.end(),
    [](const Block& block) { return !block.IsOwn || recon::IsInMillimetres(block.Surface); });
  const std::vector<int> ofRanks = ranks.Gather({ all ? 1 : 0 });
  return std::all_of(ofRanks.begin(), ofRanks.end(), [](int yes) { return yes != 0; });
}

std::vector<recon::JudgedSurface> JudgeOwn(
  const std::vector<Block>& blocks, bool millimetres, bool withContours)
{
  std::vector<recon::JudgedSurface> judged;
  for (const Block& block : blocks)
  {
    if (block.IsOwn)
    {
      judged.push_back(
        recon::Judge(block.Certificate, block.Name, block.Number, millimetres, withContours));
    }
  }
  return judged;
}

/// What all ranks have judged, in the order of blocks, on the first one; nothing on the others.
std::vector<recon::JudgedSurface> GatherJudged(
  const std::vector<recon::JudgedSurface>& own, const recon::Ranks& ranks)
{
  if (!ranks.AreSeveral())
  {
    return own;
  }
  vtkMultiProcessStream sent;
  recon::Send(own, sent);
  std::vector<recon::JudgedSurface> all;
  for (vtkMultiProcessStream& stream : ranks.GatherOnRoot(sent))
  {
    const std::vector<recon::JudgedSurface> judged = recon::Receive(stream);
    all.insert(all.end(), judged.begin(), judged.end());
  }
  std::sort(all.begin(), all.end(),
    [](const recon::JudgedSurface& a, const recon::JudgedSurface& b)
    { return a.Number < b.Number; });
  return all;
}

/// What is wrong with a surface of one rank is wrong for all: none may wait for another.
void RethrowOnAll(std::exception_ptr failure, const recon::Ranks& ranks)
{
  const std::vector<int> failed = ranks.Gather({ failure ? 1 : 0 });
  if (failure)
  {
    std::rethrow_exception(failure);
  }
  const auto first = std::find(failed.begin(), failed.end(), 1);
  if (first != failed.end())
  {
    throw recon::Error("Rank " + std::to_string(first - failed.begin()) +
      " could not judge a surface of its own, and says why.");
  }
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

int vtkSurfaceCertificate::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  recon::AnswerPieces(outputVector);
  return 1;
}

int vtkSurfaceCertificate::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
  vtkTable* table = vtkTable::GetData(outputVector, 1);
  vtkTable* components = vtkTable::GetData(outputVector, 2);
  this->Verdict.clear();
  return recon::RunOnAnything(this, { output, table, components },
    [&]
    {
      table->Initialize();
      components->Initialize();
      const recon::Ranks ranks(inputVector[0]);
      const auto places = ranks.FindPlaces(input);
      const auto contours =
        ranks.BringToAll(vtkDataObject::GetData(inputVector[1]), recon::SpreadBlocks::Append);
      std::vector<Block> blocks;
      std::exception_ptr failure;
      try
      {
        const auto surfaces = recon::ListPolyData(input);
        const auto matched = recon::MatchContours(surfaces, contours);
        recon::CertificateOptions options;
        options.Weld = this->Weld;
        options.Threads = this->Threads;
        for (std::size_t s = 0; s < surfaces.size(); ++s)
        {
          const double count = static_cast<double>(surfaces.size());
          vtkContourMonitor monitor(this, s / count, (s + 1) / count);
          blocks.push_back(CertifyBlock(surfaces[s], places[s], matched[s], options, monitor));
        }
      }
      catch (...)
      {
        failure = std::current_exception();
      }
      RethrowOnAll(failure, ranks);
      FillOutput(input, blocks, output);
      const bool withBlocks = !vtkPolyData::SafeDownCast(input);
      const auto judged =
        GatherJudged(JudgeOwn(blocks, AreInMillimetres(blocks, ranks), contours != nullptr), ranks);
      recon::FillReadingTable(judged, withBlocks, table);
      recon::FillComponentTable(judged, withBlocks, components);
      this->Verdict = recon::VerdictOf(judged, withBlocks);
    });
}
