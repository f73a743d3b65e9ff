// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Pieces.h
 * @brief Regions spread over the pieces that a pipeline asks for, which are the ranks of an MPI server.
 *
 * A region is always whole, in one piece, as its surface depends on all of its contours. Collections have
 * the same structure in every piece: the regions of other pieces are blocks without points, with the
 * name, number and colour that the region has, and say in the field data array `OwnerRank` where it is.
 */
#ifndef Pieces_h
#define Pieces_h

#include "ContourFiltersModule.h" // for export macro

#include <cstddef>
#include <optional>
#include <vector>

class vtkDataObject;
class vtkInformationVector;
class vtkPolyData;

namespace recon
{
struct Piece
{
  int Number = 0;
  int Count = 1;
};

/// What is asked of the first output, or input; all of it where nothing was said.
[[nodiscard]] CONTOURFILTERS_EXPORT Piece RequestedPiece(vtkInformationVector* infos);

/// For RequestInformation of a source that looks at RequestedPiece.
CONTOURFILTERS_EXPORT void AnswerPieces(vtkInformationVector* outputVector);

/// For RequestUpdateExtent: a small input beside the main one (planes, a table) is needed whole in every
/// piece.
CONTOURFILTERS_EXPORT void RequestWhole(vtkInformationVector* inputVector);

/// Regions and the piece of each.
class CONTOURFILTERS_EXPORT RegionShares
{
public:
  /// weights: what a region takes, the number of its points.
  RegionShares(const std::vector<std::size_t>& weights, Piece piece);

  bool IsOwn(std::size_t region) const { return this->OwnerOf[region] == this->Asked.Number; }
  /// Says in the block of a region of another piece where it is.
  void Mark(std::size_t region, vtkPolyData* block) const;

private:
  std::vector<int> OwnerOf;
  Piece Asked;
};

/// The piece where RegionShares says that the region of this block is; nothing where it is here.
[[nodiscard]] CONTOURFILTERS_EXPORT std::optional<int> OwnerElsewhere(vtkDataObject* block);

/// Takes away what RegionShares said.
CONTOURFILTERS_EXPORT void ForgetOwner(vtkDataObject* block);
}

#endif
