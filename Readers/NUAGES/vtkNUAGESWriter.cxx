// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkNUAGESWriter.h"

#include "Common/ClosedLoops.h"
#include "ContourConversion.h"
#include "NUAGES/NUAGESFormatter.h"
#include "vtkContourMonitor.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <utility>
#include <vector>

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

/// The depth of every cell in the tree of nesting; empty where the input does not tell.
std::vector<int> DepthsOf(vtkPolyData* input)
{
  std::vector<int> depths;
  vtkDataArray* array = input->GetCellData()->GetArray("Depth");
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    depths.push_back(static_cast<int>(array->GetTuple1(i)));
  }
  return depths;
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

void vtkNUAGESWriter::WriteWhole()
{
  vtkContourMonitor monitor(this);
  vtkPolyData* input = ContoursOf(this->GetWhole());
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
    report.push_back(std::to_string(looseVertices) + " loose vertices are no contours; left out.");
  }
  recon::OrientByDepth(DepthsOf(input), closed);
  const std::vector<std::string> moved = recon::WriteNUAGES(this->FileName, closed, monitor);
  report.insert(report.end(), moved.begin(), moved.end());
  for (const std::string& line : report)
  {
    vtkWarningMacro(<< line);
  }
}
