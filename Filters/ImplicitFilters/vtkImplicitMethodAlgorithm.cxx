// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkImplicitMethodAlgorithm.h"

void vtkImplicitMethodAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->Mode << "\n";
  os << indent << "Values: " << this->Values << "\n";
  os << indent << "Normals: " << this->Normals << "\n";
  os << indent << "MarginDistance: " << this->MarginDistance << "\n";
  os << indent << "ReachAcrossSteps: " << this->ReachAcrossSteps << "\n";
  os << indent << "MergeBox: " << this->MergeBox << "\n";
  os << indent << "ThinOut: " << this->ThinOut << "\n";
  os << indent << "FillLongEdges: " << this->FillLongEdges << "\n";
  os << indent << "FollowDrawnPlanes: " << this->FollowDrawnPlanes << "\n";
  os << indent << "ResampleSpacing: " << this->ResampleSpacing << "\n";
  os << indent << "ResampleTolerance: " << this->ResampleTolerance << "\n";
  os << indent << "Threads: " << this->Threads << "\n";
}
