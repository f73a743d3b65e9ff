// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkPolyhedralAlgorithm.h"

#include "JoinTable.h"
#include "Polyhedral/PolyhedralSurface.h"
#include "Polyhedral/TopologyContract.h"
#include "vtkContourMonitor.h"

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
double vtkPolyhedralAlgorithm::MeetContract(
  const recon::ContourSet& contours, double from, recon::PolyhedralOptions& options)
{
  if (!recon::AsksForTopology(options))
  {
    return from;
  }
  constexpr double SearchEnd = 0.7;
  vtkContourMonitor searching(this, from, SearchEnd);
  options.Contract = recon::MeetContract(contours, options, searching).Decisions;
  return SearchEnd;
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
