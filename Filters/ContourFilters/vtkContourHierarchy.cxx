// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkContourHierarchy.h"

#include "ContourConversion.h"
#include "Contours/ContourSetBuilder.h"
#include "vtkContourMonitor.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkContourHierarchy);

namespace
{
/// What the input knew about a cell stays with the contours that came from it.
void PassCellData(const recon::ContourSet& set, vtkPolyData* input, vtkPolyData* output)
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

void PassFieldData(vtkPolyData* input, vtkPolyData* output)
{
  vtkFieldData* from = input->GetFieldData();
  vtkFieldData* to = output->GetFieldData();
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = from->GetAbstractArray(a);
    if (array->GetName() && !to->HasArray(array->GetName()))
    {
      to->AddArray(array);
    }
  }
}
}

void vtkContourHierarchy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ParallelPlanesOnly: " << (this->ParallelPlanesOnly ? "On" : "Off") << endl;
  os << indent << "PlaneTolerance: " << this->PlaneTolerance << endl;
}

int vtkContourHierarchy::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (!input || !output)
  {
    vtkErrorMacro(
      "Contour Hierarchy needs contours as poly data: connect a contour reader or Slice.");
    return 0;
  }
  if (input->GetNumberOfCells() == 0)
  {
    // Regions of interest without contours are common; in a collection they must not stop the
    // others.
    PassFieldData(input, output);
    return 1;
  }
  try
  {
    vtkContourMonitor monitor(this);
    const recon::ConvertedLoops loops = recon::ToLoopSoup(input);
    recon::ContourSetOptions options;
    options.Parallel = this->ParallelPlanesOnly;
    options.PlaneTolerance = this->PlaneTolerance;
    const recon::ContourSet set = recon::BuildContourSet(loops.Soup, options, monitor);
    std::vector<std::string> report = recon::GetReport(input);
    report.insert(report.end(), loops.Report.begin(), loops.Report.end());
    recon::ToPolyData(set, report, output);
    PassCellData(set, input, output);
    PassFieldData(input, output);
    return 1;
  }
  catch (const recon::Aborted&)
  {
    output->Initialize();
    return 1;
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
}
