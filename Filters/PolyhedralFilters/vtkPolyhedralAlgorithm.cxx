// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPolyhedralAlgorithm.h"

#include "JoinTable.h"
#include "Polyhedral/PolyhedralSurface.h"

//------------------------------------------------------------------------------
recon::PolyhedralOptions vtkPolyhedralAlgorithm::GetOptions(vtkPolyData* input,
  const recon::ContourSet& contours, vtkTable* overrides, std::vector<std::string>& report)
{
  recon::ContourMappingOptions joins = this->GetMappingOptions(overrides);
  const std::string sentence = recon::ReadMapping(input, contours, joins);
  if (!sentence.empty())
  {
    report.push_back(sentence);
  }
  recon::PolyhedralOptions options;
  options.InternalPoints = this->InternalPoints;
  options.LiftInternalPoints = this->LiftInternalPoints;
  options.Mapping = static_cast<recon::PolyhedralOptions::MappingType>(this->Mapping);
  options.OverlapThreshold = joins.OverlapThreshold;
  options.ForcedJoins = joins.ForcedJoins;
  options.ForbiddenJoins = joins.ForbiddenJoins;
  options.MaximumGap = joins.MaximumGap;
  options.AlignLevels = static_cast<recon::LevelAlignmentMode>(this->GetAlignLevels());
  options.EndCaps = static_cast<recon::PolyhedralOptions::EndCapsType>(this->EndCaps);
  options.IsolatedContours =
    static_cast<recon::PolyhedralOptions::IsolatedContoursType>(this->IsolatedContours);
  options.ExpectedPieces = this->GetExpectedPieces();
  options.ExpectedHandles = this->GetExpectedHandles();
  options.Threads = joins.Threads;
  return options;
}

//------------------------------------------------------------------------------
void vtkPolyhedralAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InternalPoints: " << this->InternalPoints << '\n'
     << indent << "LiftInternalPoints: " << this->LiftInternalPoints << '\n'
     << indent << "Mapping: " << this->Mapping << '\n'
     << indent << "EndCaps: " << this->EndCaps << '\n'
     << indent << "IsolatedContours: " << this->IsolatedContours << '\n';
}
