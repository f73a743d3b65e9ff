// SPDX-License-Identifier: GPL-3.0-or-later
#include "InputArrays.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace recon
{
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

void PassInputFieldData(vtkPolyData* input, vtkPolyData* output)
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
