// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkBRepWriter.h"

#include "Base/SubMonitor.h"
#include "BRep/BRepContours.h"
#include "BRep/BRepFormatter.h"
#include "Common/RegionFiles.h"
#include "ContourConversion.h"
#include "SurfaceBlocks.h"
#include "vtkContourMonitor.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkBRepWriter);

namespace
{
void AppendLoops(
  vtkPolyData* contours, std::vector<recon::SpaceLoop>& loops, recon::Monitor& monitor)
{
  if (contours->GetNumberOfLines() + contours->GetNumberOfPolys() == 0)
  {
    return;
  }
  const std::vector<recon::SpaceLoop> closed =
    recon::ClosedSpaceLoops(recon::ToLoopSoup(contours).Soup, monitor);
  loops.insert(loops.end(), closed.begin(), closed.end());
}

std::vector<recon::SpaceLoop> LoopsOf(
  vtkPolyData* surface, vtkPolyData* contours, recon::Monitor& monitor)
{
  std::vector<recon::SpaceLoop> loops;
  vtkNew<vtkPolyData> lines;
  lines->SetPoints(surface->GetPoints());
  lines->SetLines(surface->GetLines());
  AppendLoops(lines, loops, monitor);
  if (contours)
  {
    AppendLoops(contours, loops, monitor);
  }
  return loops;
}

/// The shell set of every triangle; empty where the surface does not tell.
std::vector<int> ShellSetsOf(vtkPolyData* surface)
{
  std::vector<int> sets;
  vtkDataArray* array = surface->GetCellData()->GetArray("ShellSet");
  if (!array)
  {
    return sets;
  }
  // vtkPolyData counts vertices and lines before polygons.
  const vtkIdType first = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  for (vtkIdType i = 0; i < surface->GetNumberOfPolys(); ++i)
  {
    sets.push_back(static_cast<int>(array->GetTuple1(first + i)));
  }
  return sets;
}
}

vtkBRepWriter::vtkBRepWriter()
{
  this->SetNumberOfInputPorts(2);
}

vtkBRepWriter::~vtkBRepWriter()
{
  this->SetFileName(nullptr);
}

void vtkBRepWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << endl;
}

int vtkBRepWriter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

void vtkBRepWriter::WriteSurface(
  vtkPolyData* surface, vtkPolyData* contours, const std::string& fileName, recon::Monitor& monitor)
{
  recon::SubMonitor joining(monitor, 0.0, 0.6);
  const recon::TriangleMesh mesh = recon::ToTriangleMesh(surface);
  const std::vector<recon::SpaceLoop> loops = LoopsOf(surface, contours, joining);
  std::vector<int> missing;
  const recon::BRep brep = recon::MakeBRep(mesh, ShellSetsOf(surface), loops, missing, joining);
  recon::SubMonitor writing(monitor, 0.6, 1.0);
  recon::WriteBRep(fileName, brep, writing);
  if (!missing.empty())
  {
    vtkWarningMacro(<< missing.size() << " of " << loops.size() << " contours (the first is number "
                    << missing.front()
                    << ") do not run along edges of the surface and were left out.");
  }
}

void vtkBRepWriter::WriteRegions()
{
  const std::vector<recon::NamedPolyData> regions = recon::ListSurfaces(this->GetWhole());
  const std::vector<vtkPolyData*> contours = recon::MatchContours(regions, this->GetWhole(1));
  const auto count = static_cast<double>(regions.size());
  recon::WriteRegionFiles(recon::NamesOf(regions), this->FileName,
    [&](std::size_t r, const std::string& file)
    {
      vtkContourMonitor monitor(
        this, static_cast<double>(r) / count, static_cast<double>(r + 1) / count);
      this->WriteSurface(regions[r].Data, contours[r], file, monitor);
    });
}

void vtkBRepWriter::WriteWhole()
{
  if (vtkDataObjectTree::SafeDownCast(this->GetWhole()))
  {
    this->WriteRegions();
    return;
  }
  vtkPolyData* surface = vtkPolyData::SafeDownCast(this->GetWhole());
  if (!surface)
  {
    throw recon::Error("There is no surface to write: connect one to the writer.");
  }
  vtkContourMonitor monitor(this);
  this->WriteSurface(
    surface, vtkPolyData::SafeDownCast(this->GetWhole(1)), this->FileName, monitor);
}
