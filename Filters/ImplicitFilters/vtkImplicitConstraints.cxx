// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkImplicitConstraints.h"

#include "ContourConversion.h"
#include "Contours/Specks.h"
#include "FieldArrays.h"
#include "Implicit/Constraints/ContourFit.h"
#include "ImplicitData.h"
#include "ImplicitOptions.h"
#include "RunCore.h"
#include "vtkContourMonitor.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkImplicitConstraints);

namespace
{
/// Refined margins need a fit; margins in the plane do not, and wait for none.
recon::ConstraintSet ConstraintsOf(const recon::ContourSet& contours,
  const recon::ConstraintOptions& options, const recon::FunctionOptions& fitting,
  recon::Monitor& monitor)
{
  if (options.Normals == recon::ConstraintOptions::Refined &&
    options.Mode == recon::ConstraintOptions::Margins)
  {
    return recon::FitContours(contours, options, fitting, monitor).Constraints;
  }
  return recon::BuildInPlaneConstraints(
    recon::PrepareContours(contours, options), options, monitor);
}
}

//------------------------------------------------------------------------------
int vtkImplicitConstraints::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0], 0);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  return recon::RunCore(this, input, recon::NeedsContours, { output },
    [&]
    {
      vtkContourMonitor cleaning(this, 0.0, 0.1);
      const recon::ContourSet contours = this->ReadContoursOfSolid(input, false, cleaning);
      vtkContourMonitor placing(this, 0.1, 1.0);
      recon::FunctionOptions fitting;
      fitting.Threads = this->GetThreads();
      const recon::ConstraintSet constraints =
        ConstraintsOf(contours, recon::ConstraintOptionsOf(this), fitting, placing);
      recon::ToPolyData(constraints, output);
      recon::AddValue(output->GetFieldData(), "SmallestContourArea", recon::SmallestArea(contours));
      std::vector<std::string> report = contours.Report;
      report.insert(report.end(), constraints.Report.begin(), constraints.Report.end());
      recon::FinishOutput(input, report, output);
    });
}
