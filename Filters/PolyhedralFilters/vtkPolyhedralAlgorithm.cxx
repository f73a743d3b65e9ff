// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPolyhedralAlgorithm.h"

#include "JoinTable.h"
#include "Polyhedral/PolyhedralSurface.h"

#include "vtkInformation.h"
#include "vtkTable.h"

//------------------------------------------------------------------------------
vtkPolyhedralAlgorithm::vtkPolyhedralAlgorithm()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
void vtkPolyhedralAlgorithm::SetOverridesConnection(vtkAlgorithmOutput* overrides)
{
  this->SetInputConnection(1, overrides);
}

//------------------------------------------------------------------------------
int vtkPolyhedralAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
void vtkPolyhedralAlgorithm::AddForcedJoin(int contour, int otherContour)
{
  this->ForcedJoins.emplace_back(contour, otherContour);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPolyhedralAlgorithm::RemoveAllForcedJoins()
{
  this->ForcedJoins.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPolyhedralAlgorithm::AddForbiddenJoin(int contour, int otherContour)
{
  this->ForbiddenJoins.emplace_back(contour, otherContour);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPolyhedralAlgorithm::RemoveAllForbiddenJoins()
{
  this->ForbiddenJoins.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
recon::PolyhedralOptions vtkPolyhedralAlgorithm::GetOptions(vtkPolyData* input,
  const recon::ContourSet& contours, vtkTable* overrides, std::vector<std::string>& report) const
{
  recon::ContourMappingOptions joins;
  joins.ForcedJoins = this->ForcedJoins;
  joins.ForbiddenJoins = this->ForbiddenJoins;
  if (overrides)
  {
    recon::ReadJoinOverrides(overrides, joins);
  }
  const std::string sentence = recon::ReadMapping(input, contours, joins);
  if (!sentence.empty())
  {
    report.push_back(sentence);
  }
  recon::PolyhedralOptions options;
  options.InternalPoints = this->InternalPoints;
  options.LiftInternalPoints = this->LiftInternalPoints;
  options.Mapping = static_cast<recon::PolyhedralOptions::MappingType>(this->Mapping);
  options.OverlapThreshold = this->OverlapThreshold;
  options.ForcedJoins = joins.ForcedJoins;
  options.ForbiddenJoins = joins.ForbiddenJoins;
  options.MaximumGap = this->MaximumGap;
  options.AlignLevels = static_cast<recon::LevelAlignmentMode>(this->AlignLevels);
  options.EndCaps = static_cast<recon::PolyhedralOptions::EndCapsType>(this->EndCaps);
  options.IsolatedContours =
    static_cast<recon::PolyhedralOptions::IsolatedContoursType>(this->IsolatedContours);
  options.Threads = this->Threads;
  return options;
}

//------------------------------------------------------------------------------
void vtkPolyhedralAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InternalPoints: " << this->InternalPoints << '\n'
     << indent << "LiftInternalPoints: " << this->LiftInternalPoints << '\n'
     << indent << "Mapping: " << this->Mapping << '\n'
     << indent << "OverlapThreshold: " << this->OverlapThreshold << '\n'
     << indent << "ForcedJoins: " << this->ForcedJoins.size() << '\n'
     << indent << "ForbiddenJoins: " << this->ForbiddenJoins.size() << '\n'
     << indent << "MaximumGap: " << this->MaximumGap << '\n'
     << indent << "AlignLevels: " << this->AlignLevels << '\n'
     << indent << "EndCaps: " << this->EndCaps << '\n'
     << indent << "IsolatedContours: " << this->IsolatedContours << '\n'
     << indent << "Threads: " << this->Threads << '\n';
}
