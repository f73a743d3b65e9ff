// SPDX-License-Identifier: GPL-3.0-or-later
#include "SurfaceSummaries.h"

#include "FieldArrays.h"
#include "Mesh/SurfaceSummary.h"
#include "SurfaceBlocks.h"

#include "vtkPolyData.h"

namespace recon
{
bool IsInMillimetres(vtkPolyData* data)
{
  vtkFieldData* figures = data->GetFieldData();
  if (auto* unit = vtkStringArray::SafeDownCast(figures->GetAbstractArray("LengthUnit")))
  {
    return unit->GetNumberOfValues() > 0 && unit->GetValue(0) == "mm";
  }
  return figures->HasArray("ROINumber") != 0;
}

void AddSummary(const TriangleMesh& mesh, vtkPolyData* input, vtkPolyData* output)
{
  AddValue(output->GetFieldData(), SummaryName, SummariseSurface(mesh, IsInMillimetres(input)));
}

std::string SummariesOf(vtkDataObject* output)
{
  std::string text;
  for (const NamedPolyData& block : ListPolyData(output))
  {
    const std::string summary = FieldText(block.Data->GetFieldData(), SummaryName);
    if (!summary.empty())
    {
      text += (block.Name.empty() ? "" : block.Name + ": ") + summary + "\n";
    }
  }
  return text;
}
}
