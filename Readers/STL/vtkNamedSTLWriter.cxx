// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkNamedSTLWriter.h"

#include "Common/RegionFiles.h"
#include "Common/ReplacedFile.h"
#include "SurfaceBlocks.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSTLWriter.h"

#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkNamedSTLWriter);

namespace
{
/// The points as the file will have them.
vtkSmartPointer<vtkPoints> InSinglePrecision(vtkPoints* points)
{
  auto rounded = vtkSmartPointer<vtkPoints>::New();
  rounded->SetDataTypeToFloat();
  rounded->SetNumberOfPoints(points->GetNumberOfPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double place[3];
    points->GetPoint(i, place);
    for (const double coordinate : place)
    {
      if (!(std::abs(coordinate) <= std::numeric_limits<float>::max()))
      {
        throw recon::Error("Point " + std::to_string(i) +
          " has a coordinate that single precision, and so STL, cannot hold.");
      }
    }
    rounded->SetPoint(i, place);
  }
  return rounded;
}

/// Two corners in one place, which they were not before.
bool IsFlattened(vtkPoints* before, vtkPoints* after, vtkIdType a, vtkIdType b)
{
  double p[3];
  double q[3];
  const auto same = [&](vtkPoints* points)
  {
    points->GetPoint(a, p);
    points->GetPoint(b, q);
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
  };
  return same(after) && !same(before);
}

vtkIdType CountFlattened(vtkPolyData* surface, vtkPoints* rounded)
{
  vtkIdType count = 0;
  const auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* corners;
    cells->GetCurrentCell(size, corners);
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (IsFlattened(surface->GetPoints(), rounded, corners[i], corners[(i + 1) % size]))
      {
        ++count;
        break;
      }
    }
  }
  return count;
}
}

vtkNamedSTLWriter::~vtkNamedSTLWriter()
{
  this->SetFileName(nullptr);
}

void vtkNamedSTLWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << endl;
}

int vtkNamedSTLWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  return 1;
}

void vtkNamedSTLWriter::WriteSurface(
  vtkPolyData* surface, const std::string& name, const std::string& fileName)
{
  const auto rounded = InSinglePrecision(surface->GetPoints());
  const vtkIdType flattened = CountFlattened(surface, rounded);
  vtkNew<vtkPolyData> written;
  written->SetPoints(rounded);
  written->SetPolys(surface->GetPolys());
  recon::ReplacedFile file(fileName);
  vtkNew<vtkSTLWriter> writer;
  writer->SetInputData(written);
  writer->SetFileName(file.GetPart().c_str());
  writer->SetFileTypeToBinary();
  if (!writer->Write() || writer->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw recon::Error("\"" + fileName + "\" could not be written: is the disk full?");
  }
  file.Commit();
  if (flattened > 0)
  {
    vtkWarningMacro(<< (name.empty() ? fileName : "\"" + name + "\"") << ": " << flattened
                    << " triangles have no area in single precision, which STL has; .vtp and .ply "
                       "keep them, or move the surface nearer to the origin.");
  }
}

void vtkNamedSTLWriter::WriteWhole()
{
  const std::vector<recon::NamedPolyData> regions = recon::ListSurfaces(this->GetWhole());
  recon::WriteRegionFiles(recon::NamesOf(regions), this->FileName,
    [&](std::size_t r, const std::string& file)
    {
      this->WriteSurface(regions[r].Data, regions[r].Name, file);
      this->UpdateProgress(static_cast<double>(r + 1) / static_cast<double>(regions.size()));
    });
}
