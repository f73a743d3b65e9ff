// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkImplicitContours.h"

#include "ContourConversion.h"
#include "Contours/Specks.h"
#include "Implicit/ZeroSet/ContourTracer.h"
#include "ImplicitData.h"
#include "ImplicitOptions.h"
#include "RunCore.h"
#include "vtkContourMonitor.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

vtkStandardNewMacro(vtkImplicitContours);

namespace
{
double FirstOf(vtkFieldData* data, const char* name, double otherwise)
{
  vtkDataArray* array = data ? data->GetArray(name) : nullptr;
  return array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : otherwise;
}

double SmallestAreaOf(vtkImplicitContours* filter, vtkDataObject* model, vtkDataObject* planes)
{
  if (filter->GetSmallestArea() != 0)
  {
    return std::max(0.0, filter->GetSmallestArea());
  }
  auto* slices = vtkPolyData::SafeDownCast(planes);
  const double pixel = slices ? FirstOf(slices->GetCellData(), "PixelArea", 0) : 0;
  const double drawn = FirstOf(model->GetFieldData(), "SmallestContourArea", 0);
  return recon::SpeckArea(pixel, drawn);
}

recon::TracerOptions OptionsOf(
  vtkImplicitContours* filter, vtkDataObject* model, vtkDataObject* planes)
{
  recon::TracerOptions options;
  options.CellSize = filter->GetCellSize();
  options.Box = recon::BoxOf(filter);
  options.MaximumCells = filter->GetMaximumCells();
  options.Threads = filter->GetThreads();
  options.SmallestArea = SmallestAreaOf(filter, model, planes);
  return options;
}

/// How far beyond the outermost contour points a plane of the second input may lie, if it tells.
std::optional<double> ToleranceOf(vtkDataObject* second)
{
  const double told = FirstOf(second->GetFieldData(), "ContourTolerance", -1);
  return told < 0 ? std::nullopt : std::optional<double>(told);
}

/// The slices of an image, through its pixels' centres, whatever way it is turned.
std::vector<recon::TracePlane> SlicesOf(vtkImageData* image)
{
  int extent[6];
  image->GetExtent(extent);
  double origin[3];
  double alongI[3];
  double alongJ[3];
  image->TransformIndexToPhysicalPoint(extent[0], extent[2], extent[4], origin);
  image->TransformIndexToPhysicalPoint(extent[0] + 1, extent[2], extent[4], alongI);
  image->TransformIndexToPhysicalPoint(extent[0], extent[2] + 1, extent[4], alongJ);
  recon::Vector3 i{};
  recon::Vector3 j{};
  for (int a = 0; a < 3; ++a)
  {
    i[a] = alongI[a] - origin[a];
    j[a] = alongJ[a] - origin[a];
  }
  const recon::PlanarFrame frame = recon::FrameAbout(recon::Cross(i, j));
  std::vector<recon::TracePlane> planes;
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    recon::Point3 p{};
    image->TransformIndexToPhysicalPoint(extent[0], extent[2], k, p.data());
    planes.push_back({ frame, frame.OffsetOf(p) });
  }
  return planes;
}

std::vector<recon::TracePlane> RangeOf(
  vtkImplicitContours* filter, const std::vector<recon::Point3>& seeds)
{
  recon::Vector3 normal{};
  std::copy_n(filter->GetPlaneNormal(), 3, normal.begin());
  std::optional<std::array<double, 2>> range;
  if (filter->GetUseRange())
  {
    range = { filter->GetRange()[0], filter->GetRange()[1] };
  }
  return recon::ParallelPlanesThrough(seeds, normal, range, filter->GetSpacing());
}

std::vector<recon::TracePlane> PlanesOf(
  vtkDataObject* second, vtkImplicitContours* filter, const std::vector<recon::Point3>& seeds)
{
  if (vtkImageData* image = vtkImageData::SafeDownCast(second))
  {
    return SlicesOf(image);
  }
  if (vtkPolyData* contours = vtkPolyData::SafeDownCast(second))
  {
    recon::ContourSetOptions options;
    options.Parallel = false;
    recon::Monitor silent;
    return recon::PlanesOf(recon::ReadContours(contours, options, silent));
  }
  return RangeOf(filter, seeds);
}
}

//------------------------------------------------------------------------------
vtkImplicitContours::vtkImplicitContours()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
int vtkImplicitContours::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkImplicitContours::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0], 0);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  return recon::RunCore(this, input, recon::NeedsModel, { output },
    [&]
    {
      const recon::ImplicitFunction function = recon::ToFunction(input);
      const std::vector<recon::Point3> seeds = recon::SeedsOf(function);
      vtkDataObject* second = vtkDataObject::GetData(inputVector[1], 0);
      std::vector<std::string> report = recon::GetReport(input);
      std::vector<recon::TracePlane> planes = PlanesOf(second, this, seeds);
      if (second && !this->Extrapolate)
      {
        planes = recon::OnlyPlanesWithin(planes, seeds, ToleranceOf(second), report);
      }
      vtkContourMonitor tracing(this);
      const recon::ContourSet contours =
        recon::TraceContours(function, seeds, planes, OptionsOf(this, input, second), tracing);
      recon::ToPolyData(contours, output);
      report.insert(report.end(), contours.Report.begin(), contours.Report.end());
      recon::FinishOutput(input, report, output);
    });
}

//------------------------------------------------------------------------------
void vtkImplicitContours::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Extrapolate: " << this->Extrapolate << "\n";
  os << indent << "SmallestArea: " << this->SmallestArea << "\n";
  os << indent << "PlaneNormal:";
  for (const double x : this->PlaneNormal)
  {
    os << " " << x;
  }
  os << "\n";
  os << indent << "UseRange: " << this->UseRange << "\n";
  os << indent << "Range:";
  for (const double x : this->Range)
  {
    os << " " << x;
  }
  os << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "CellSize: " << this->CellSize << "\n";
  os << indent << "UseBounds: " << this->UseBounds << "\n";
  os << indent << "Bounds:";
  for (const double x : this->Bounds)
  {
    os << " " << x;
  }
  os << "\n";
  os << indent << "MaximumCells: " << this->MaximumCells << "\n";
  os << indent << "Threads: " << this->Threads << "\n";
}
