// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkNUAGESWriter.h"

#include "Common/ClosedLoops.h"
#include "ContourConversion.h"
#include "NUAGES/NUAGESFormatter.h"
#include "RunCore.h"
#include "vtkContourMonitor.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkNUAGESWriter);

namespace
{
/// The one vtkPolyData of the input; a file holds one set of contours.
vtkPolyData* ContoursOf(vtkDataObject* input)
{
  if (auto* polyData = vtkPolyData::SafeDownCast(input))
  {
    return polyData;
  }
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    throw recon::Error("There are no contours to write: connect contours to the writer.");
  }
  vtkPolyData* found = nullptr;
  const vtkSmartPointer<vtkCompositeDataIterator> leaf =
    vtk::TakeSmartPointer(composite->NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    auto* block = vtkPolyData::SafeDownCast(leaf->GetCurrentDataObject());
    if (!block || block->GetNumberOfCells() == 0)
    {
      continue;
    }
    if (found)
    {
      throw recon::Error(
        "The input has several blocks with contours, and a NUAGES file holds one: pick one with "
        "the Extract Block filter.");
    }
    found = block;
  }
  if (!found)
  {
    throw recon::Error("There are no contours to write: all blocks of the input are empty.");
  }
  return found;
}

double SignedAreaInXY(const recon::LoopSoup& soup, const std::vector<int>& loop)
{
  using recon::operator-;
  double twice = 0;
  const recon::Point3& origin = soup.Points[static_cast<std::size_t>(loop.front())];
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const recon::Vector3 a = soup.Points[static_cast<std::size_t>(loop[i])] - origin;
    const recon::Vector3 b =
      soup.Points[static_cast<std::size_t>(loop[(i + 1) % loop.size()])] - origin;
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2;
}

/// The format's convention, seen from +z: outer contours clockwise, holes counterclockwise.
void OrientByDepth(vtkPolyData* input, recon::LoopSoup& soup)
{
  vtkDataArray* depth = input->GetCellData()->GetArray("Depth");
  if (!depth)
  {
    return;
  }
  for (recon::LoopSoup::Chain& chain : soup.Chains)
  {
    const bool isHole = static_cast<int>(depth->GetTuple1(chain.Source)) % 2 != 0;
    const double area = SignedAreaInXY(soup, chain.Points);
    if (isHole ? area < 0 : area > 0)
    {
      std::reverse(chain.Points.begin() + 1, chain.Points.end());
    }
  }
}
}

vtkNUAGESWriter::vtkNUAGESWriter() = default;

vtkNUAGESWriter::~vtkNUAGESWriter()
{
  this->SetFileName(nullptr);
}

void vtkNUAGESWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << endl;
}

int vtkNUAGESWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

void vtkNUAGESWriter::WriteData()
{
  this->SetErrorCode(recon::RunOnFile(this, this->FileName, "the NUAGES file to write (.cnt)",
    vtkErrorCode::CannotOpenFileError, {},
    [&]
    {
      vtkContourMonitor monitor(this);
      vtkPolyData* input = ContoursOf(this->GetInput());
      recon::ConvertedLoops converted = recon::ToLoopSoup(input);
      std::vector<std::string> report = std::move(converted.Report);
      int looseVertices = 0;
      recon::LoopSoup closed =
        recon::CloseLoops(std::move(converted.Soup), "NUAGES files hold", looseVertices, monitor);
      if (closed.Chains.empty())
      {
        throw recon::Error("There are no closed contours to write.");
      }
      if (looseVertices > 0)
      {
        report.push_back(
          std::to_string(looseVertices) + " loose vertices are no contours; left out.");
      }
      OrientByDepth(input, closed);
      const std::vector<std::string> moved = recon::WriteNUAGES(this->FileName, closed, monitor);
      report.insert(report.end(), moved.begin(), moved.end());
      for (const std::string& line : report)
      {
        vtkWarningMacro(<< line);
      }
    }));
}
