// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Ranks.h
 * @brief The ranks of ParaView's MPI server, and blocks that are brought together from them.
 *
 * All but the questions is collective: each rank has to call it, and each gets the same Error.
 */
#ifndef Ranks_h
#define Ranks_h

#include "ContourFiltersModule.h" // for export macro
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkInformationVector;
class vtkMultiProcessController;
class vtkMultiProcessStream;

namespace recon
{
/// What to do about a block of which several ranks have a part.
enum class SpreadBlocks
{
  Append, ///< contours, which are chained anew
  Refuse  ///< surfaces, which would have seams
};

/// A block among those of all ranks.
struct BlockPlace
{
  int Number; ///< counted from 0
  bool IsOwn; ///< this rank has it, or stands for all where none has anything of it
};

class CONTOURFILTERS_EXPORT Ranks
{
public:
  /// Those of this program: one, where it was not started by MPI.
  Ranks();
  /// Those that have a piece each of this input; one, where all of it is asked for.
  explicit Ranks(vtkInformationVector* inputVector);

  bool AreSeveral() const { return this->Count > 1; }
  bool IsRoot() const { return this->Mine == 0; }
  int GetMine() const { return this->Mine; }
  int GetCount() const { return this->Count; }

  /// What each rank has, all of one length, one after the other.
  std::vector<int> Gather(const std::vector<int>& values) const;
  /// What each rank has, for the root; nothing elsewhere.
  std::vector<vtkMultiProcessStream> GatherOnRoot(const vtkMultiProcessStream& sent) const;
  /// The root's number, for all.
  int FromRoot(int value) const;

  /**
   * All blocks of poly data or of a collection of such, for the root, or for all ranks; others get
   * nullptr.
   *
   * @throws Error where the collection has another structure on another rank
   */
  vtkSmartPointer<vtkDataObject> BringToRoot(vtkDataObject* data, SpreadBlocks how) const;
  vtkSmartPointer<vtkDataObject> BringToAll(vtkDataObject* data, SpreadBlocks how) const;

  /**
   * The place of each block that ListPolyData finds here.
   *
   * @throws Error where several ranks have a part of one
   */
  std::vector<BlockPlace> FindPlaces(vtkDataObject* data) const;

  /// A sentence about the first block of which several ranks have a part; empty where there is none.
  std::string FindSpread(vtkDataObject* data) const;

private:
  Ranks(vtkMultiProcessController* controller, int mine, int count)
    : Controller(controller),
      Mine(mine),
      Count(count)
  {
  }

  vtkMultiProcessController* Controller = nullptr;
  int Mine = 0;
  int Count = 1;
};
}

#endif
