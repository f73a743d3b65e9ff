// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkContourJoinAlgorithm.h"

#include "Contours/ContourMapping.h"
#include "JoinTable.h"

#include "vtkInformation.h"
#include "vtkTable.h"

vtkContourJoinAlgorithm::vtkContourJoinAlgorithm()
{
  this->SetNumberOfInputPorts(2);
}

void vtkContourJoinAlgorithm::SetOverridesConnection(vtkAlgorithmOutput* overrides)
{
  this->SetInputConnection(1, overrides);
}

int vtkContourJoinAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkContourJoinAlgorithm::AddForcedJoin(int contour, int otherContour)
{
  this->ForcedJoins.emplace_back(contour, otherContour);
  this->Modified();
}

void vtkContourJoinAlgorithm::RemoveAllForcedJoins()
{
  this->ForcedJoins.clear();
  this->Modified();
}

void vtkContourJoinAlgorithm::AddForbiddenJoin(int contour, int otherContour)
{
  this->ForbiddenJoins.emplace_back(contour, otherContour);
  this->Modified();
}

void vtkContourJoinAlgorithm::RemoveAllForbiddenJoins()
{
  this->ForbiddenJoins.clear();
  this->Modified();
}

recon::ContourMappingOptions vtkContourJoinAlgorithm::GetMappingOptions(vtkTable* overrides) const
{
  recon::ContourMappingOptions options;
  options.OverlapThreshold = this->OverlapThreshold;
  options.MaximumGap = this->MaximumGap;
  options.ForcedJoins = this->ForcedJoins;
  options.ForbiddenJoins = this->ForbiddenJoins;
  options.Threads = this->Threads;
  if (overrides)
  {
    recon::ReadJoinOverrides(overrides, options);
  }
  return options;
}

void vtkContourJoinAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OverlapThreshold: " << this->OverlapThreshold << '\n'
     << indent << "MaximumGap: " << this->MaximumGap << '\n'
     << indent << "ExpectedPieces: " << this->ExpectedPieces << '\n'
     << indent << "ExpectedHandles: " << this->ExpectedHandles << '\n'
     << indent << "AlignLevels: " << this->AlignLevels << '\n'
     << indent << "Threads: " << this->Threads << '\n';
  const auto print = [&](const char* name, const std::vector<std::pair<int, int>>& pairs)
  {
    os << indent << name << ":";
    for (const auto& pair : pairs)
    {
      os << " (" << pair.first << ", " << pair.second << ")";
    }
    os << '\n';
  };
  print("ForcedJoins", this->ForcedJoins);
  print("ForbiddenJoins", this->ForbiddenJoins);
}
