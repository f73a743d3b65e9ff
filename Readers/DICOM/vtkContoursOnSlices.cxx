// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkContoursOnSlices.h"

#include "ContourConversion.h"
#include "DICOM/ContoursOnSlices.h"
#include "FieldArrays.h"
#include "RunCore.h"
#include "vtkContourMonitor.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <filesystem>
#include <string>

vtkStandardNewMacro(vtkContoursOnSlices);

/// Slices of the file that was read last: the regions of a structure set ask for the same ones.
struct vtkContoursOnSlices::KnownSlices
{
  std::string FileName;
  std::string Frame;
  std::filesystem::file_time_type Written;
  recon::SlicesOfReference Slices;
};

vtkContoursOnSlices::vtkContoursOnSlices() = default;

vtkContoursOnSlices::~vtkContoursOnSlices()
{
  this->SetReferenceFileName(nullptr);
}

void vtkContoursOnSlices::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent
     << "ReferenceFileName: " << (this->ReferenceFileName ? this->ReferenceFileName : "(none)")
     << endl;
  os << indent << "Method: " << this->Method << endl;
  os << indent << "Extrapolate: " << this->Extrapolate << endl;
  os << indent << "SmallestArea: " << this->SmallestArea << endl;
  os << indent << "Threads: " << this->Threads << endl;
}

const vtkContoursOnSlices::KnownSlices& vtkContoursOnSlices::ReadSlices(
  const std::string& frame, recon::Monitor& monitor)
{
  if (!this->ReferenceFileName || !*this->ReferenceFileName)
  {
    throw recon::Error("There is no Reference File Name: give the RT structure set that the "
                       "contours were drawn in, or one image of their series.");
  }
  std::error_code ignored;
  const auto written = std::filesystem::last_write_time(this->ReferenceFileName, ignored);
  if (!this->Known || this->Known->FileName != this->ReferenceFileName ||
    this->Known->Frame != frame || this->Known->Written != written)
  {
    this->Known.reset();
    recon::SlicesOfReference slices =
      recon::ReadReferenceSlices(this->ReferenceFileName, frame, monitor);
    this->Known = std::make_unique<KnownSlices>(
      KnownSlices{ this->ReferenceFileName, frame, written, std::move(slices) });
  }
  return *this->Known;
}

int vtkContoursOnSlices::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0], 0);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  return recon::RunCore(this, input, recon::NeedsContours, { output },
    [&]
    {
      recon::SliceContourOptions options;
      options.Method = static_cast<recon::SliceContourOptions::MethodType>(this->Method);
      options.Extrapolate = this->Extrapolate;
      options.SmallestArea = this->SmallestArea;
      options.Threads = this->Threads;
      vtkContourMonitor reading(this, 0.0, 0.1);
      const recon::SlicesOfReference& slices =
        this->ReadSlices(recon::FieldText(input->GetFieldData(), "FrameOfReferenceUID"), reading)
          .Slices;
      vtkContourMonitor cleaning(this, 0.1, 0.2);
      const recon::ContourSet drawn =
        this->ReadContoursOfSolid(input, this->Method == Polyhedral, cleaning);
      vtkContourMonitor tracing(this, 0.2, 1.0);
      const recon::ContourSet contours = recon::ContoursOnSlices(drawn, slices, options, tracing);
      recon::ToPolyData(contours, output);
      std::vector<std::string> report = contours.Report;
      report.insert(report.end(), slices.Report.begin(), slices.Report.end());
      recon::FinishOutput(input, report, output);
    });
}
