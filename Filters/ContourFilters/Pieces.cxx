// SPDX-License-Identifier: GPL-3.0-or-later
#include "Pieces.h"

#include "Base/BalancedShares.h"
#include "FieldArrays.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace recon
{
namespace
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

constexpr const char* OwnerName = "OwnerRank";
}

Piece RequestedPiece(vtkInformationVector* infos)
{
  vtkInformation* info = infos->GetInformationObject(0);
  Piece piece;
  if (info && info->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()))
  {
    piece.Number = info->Get(Pipeline::UPDATE_PIECE_NUMBER());
    piece.Count = info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES());
  }
  return piece;
}

void AnswerPieces(vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
}

void RequestWhole(vtkInformationVector* inputVector)
{
  for (int i = 0; i < inputVector->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* info = inputVector->GetInformationObject(i);
    info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
    info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    if (info->Has(Pipeline::WHOLE_EXTENT()))
    {
      info->Set(Pipeline::UPDATE_EXTENT(), info->Get(Pipeline::WHOLE_EXTENT()), 6);
    }
  }
}

RegionShares::RegionShares(const std::vector<std::size_t>& weights, Piece piece)
  : OwnerOf(BalancedShares(weights, piece.Count)),
    Asked(piece)
{
}

void RegionShares::Mark(std::size_t region, vtkPolyData* block) const
{
  if (!this->IsOwn(region))
  {
    AddValue(block->GetFieldData(), OwnerName, this->OwnerOf[region]);
  }
}

std::optional<int> OwnerElsewhere(vtkDataObject* block)
{
  vtkDataArray* owner = block->GetFieldData()->GetArray(OwnerName);
  return owner && owner->GetNumberOfTuples() == 1
    ? std::optional<int>(static_cast<int>(owner->GetComponent(0, 0)))
    : std::nullopt;
}

void ForgetOwner(vtkDataObject* block)
{
  block->GetFieldData()->RemoveArray(OwnerName);
}
}
