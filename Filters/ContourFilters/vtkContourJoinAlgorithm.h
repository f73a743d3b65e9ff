// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkContourJoinAlgorithm
 * @brief What decides which contours of neighbouring levels are joined: for all nodes that join them.
 *
 * They are the same with the same defaults in vtkContourMapping and in the polyhedral method's
 * nodes, so that the mapping shows what the surface is made of.
 */
#ifndef vtkContourJoinAlgorithm_h
#define vtkContourJoinAlgorithm_h

#include "ContourFiltersModule.h" // for export macro
#include "vtkContourSetAlgorithm.h"

#include <utility> // for std::pair
#include <vector>  // for std::vector

class vtkTable;

namespace recon
{
struct ContourMappingOptions;
}

class CONTOURFILTERS_EXPORT vtkContourJoinAlgorithm : public vtkContourSetAlgorithm
{
public:
  vtkTypeMacro(vtkContourJoinAlgorithm, vtkContourSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Share of the smaller region's area that two regions must have in common. Default 0.1.
  vtkSetClampMacro(OverlapThreshold, double, 0.0, 1.0);
  vtkGetMacro(OverlapThreshold, double);
  ///@}

  ///@{
  /**
   * Pairs of contours on adjacent levels (by the ContourId of vtkContourHierarchy, in either order;
   * two outer walls or two walls of holes) that are joined, or not, whatever they share. Forbidding
   * wins over forcing.
   */
  void AddForcedJoin(int contour, int otherContour);
  void RemoveAllForcedJoins();
  void AddForbiddenJoin(int contour, int otherContour);
  void RemoveAllForbiddenJoins();
  ///@}

  ///@{
  /**
   * Levels further apart than this many times the spacing beside them are not joined, but where it
   * is forced; 0: all are. Default 5: a few skipped slices are bridged (the widest gap in one shape
   * of the sets that the project is tested on is 3), two stacks of one name are not.
   */
  vtkSetClampMacro(MaximumGap, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumGap, double);
  ///@}

  ///@{
  /**
   * How many pieces and handles the surface is to have, -1 (default): any. Pieces are closed sheets,
   * the wall of a cavity is one of its own; handles those of all pieces together. The cheapest joins are
   * made, parted, or cut off between two levels that come to it; Report says which, and what
   * cannot be met.
   */
  vtkSetClampMacro(ExpectedPieces, int, -1, VTK_INT_MAX);
  vtkGetMacro(ExpectedPieces, int);
  vtkSetClampMacro(ExpectedHandles, int, -1, VTK_INT_MAX);
  vtkGetMacro(ExpectedHandles, int);
  ///@}

  ///@{
  /**
   * Shift levels onto one another before they are joined, and the surface back: for oblique shapes
   * whose sections hardly overlap (blades, swept wings, thin tubes, oblique shafts). 0: off; 1
   * (default): where two neighbouring levels have one outer contour each, of comparable size, these
   * share less than half of the smaller one, and the line through their centroids leans less than
   * 45 degrees; 2: wherever two neighbouring levels have one outer contour each. A forced join of
   * the only outer contours of two levels shifts these in any case.
   */
  vtkSetClampMacro(AlignLevels, int, 0, 2);
  vtkGetMacro(AlignLevels, int);
  ///@}

  ///@{
  /// Number of threads; 0, the default, takes all of the machine. The result does not depend on it.
  vtkSetClampMacro(Threads, int, 0, 1024);
  vtkGetMacro(Threads, int);
  ///@}

  /**
   * Optional second input: a vtkTable whose columns `LowerContour`, `UpperContour` and `Join` (1
   * force, 0 forbid) add to the forced and forbidden joins; the table that Contour Mapping gives
   * will do, as it is or edited.
   */
  void SetOverridesConnection(vtkAlgorithmOutput* overrides);

protected:
  vtkContourJoinAlgorithm();
  ~vtkContourJoinAlgorithm() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  /**
   * The properties and the overrides (the second input, or nullptr).
   *
   * @throws recon::Error for a table that is none of overrides
   */
  recon::ContourMappingOptions GetMappingOptions(vtkTable* overrides) const;

private:
  vtkContourJoinAlgorithm(const vtkContourJoinAlgorithm&) = delete;
  void operator=(const vtkContourJoinAlgorithm&) = delete;

  double OverlapThreshold = 0.1;
  double MaximumGap = 5.0;
  int ExpectedPieces = -1;
  int ExpectedHandles = -1;
  int AlignLevels = 1;
  int Threads = 0;
  std::vector<std::pair<int, int>> ForcedJoins;
  std::vector<std::pair<int, int>> ForbiddenJoins;
};

#endif
