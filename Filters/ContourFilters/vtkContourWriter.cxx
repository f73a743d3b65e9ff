// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkContourWriter.h"

#include "Ranks.h"
#include "RunCore.h"

#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkContourWriter::vtkContourWriter() = default;

vtkContourWriter::~vtkContourWriter() = default;

void vtkContourWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

vtkTypeBool vtkContourWriter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const recon::Ranks ranks;
  if (!request->Has(Pipeline::REQUEST_UPDATE_EXTENT()) || !ranks.AreSeveral())
  {
    return this->Superclass::ProcessRequest(request, inputVector, outputVector);
  }
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < inputVector[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* info = inputVector[port]->GetInformationObject(i);
      info->Set(Pipeline::UPDATE_PIECE_NUMBER(), ranks.GetMine());
      info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), ranks.GetCount());
    }
  }
  return 1;
}

void vtkContourWriter::WriteData()
{
  const recon::Ranks ranks;
  const auto how =
    this->HoldsSurfaces() ? recon::SpreadBlocks::Refuse : recon::SpreadBlocks::Append;
  const unsigned long code = recon::RunOnFile(this, this->GetTarget(), this->GetTargetKind(),
    vtkErrorCode::CannotOpenFileError, {},
    [&]
    {
      this->Inputs.clear();
      for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
      {
        this->Inputs.push_back(
          ranks.BringToRoot(this->GetInput(port), port == 0 ? how : recon::SpreadBlocks::Append));
      }
      if (ranks.IsRoot())
      {
        this->WriteWhole();
      }
    });
  this->Inputs.clear();
  this->SetErrorCode(static_cast<unsigned long>(ranks.FromRoot(static_cast<int>(code))));
}

vtkDataObject* vtkContourWriter::GetWhole(int port)
{
  return this->Inputs[static_cast<std::size_t>(port)];
}
