// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkPolyhedralAlgorithm
 * @brief The properties of the Polyhedral Surface Method, for the whole and for its stages.
 *
 * They are the same with the same defaults in vtkPolyhedralSurface, vtkContourTriangulation and
 * vtkJointVoronoiDiagram, so that a stage shows what the surface is made of.
 */
#ifndef vtkPolyhedralAlgorithm_h
#define vtkPolyhedralAlgorithm_h

#include "PolyhedralFiltersModule.h" // for the export macro
#include "vtkContourSetAlgorithm.h"

#include <string>  // for std::string
#include <utility> // for std::pair
#include <vector>  // for std::vector

class vtkTable;

namespace recon
{
struct PolyhedralOptions;
}

class POLYHEDRALFILTERS_EXPORT vtkPolyhedralAlgorithm : public vtkContourSetAlgorithm
{
public:
  vtkTypeMacro(vtkPolyhedralAlgorithm, vtkContourSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Insert vertices of the neighbouring levels' external Voronoi skeletons into a level
   * (thesis 5.3). They let a surface branch between contours. On by default.
   */
  vtkSetMacro(InternalPoints, bool);
  vtkGetMacro(InternalPoints, bool);
  vtkBooleanMacro(InternalPoints, bool);
  ///@}

  ///@{
  /**
   * Move internal points out of their level's plane, into the slab that asked for them
   * (thesis 6.2), so that ridges between branches lie between the levels. On by default.
   */
  vtkSetMacro(LiftInternalPoints, bool);
  vtkGetMacro(LiftInternalPoints, bool);
  vtkBooleanMacro(LiftInternalPoints, bool);
  ///@}

  enum MappingMode
  {
    Proximity = 0,
    Overlap = 1
  };
  enum EndCapMode
  {
    Flat = 0,
    HalfSlice = 1,
    Tapered = 2,
    NoCaps = 3
  };
  enum IsolatedContourMode
  {
    Drop = 0,
    Extrude = 1
  };

  ///@{
  /**
   * Which contours of adjacent levels may be joined: Proximity lets the Voronoi diagrams alone
   * decide (thesis chapter 5); Overlap, the default, joins only regions that share more than
   * OverlapThreshold of the smaller one's area (thesis chapter 3). It is the default because
   * Proximity bridges a finger that ends to its neighbour, which is a handle too many (see
   * Data/TRUTH.md).
   */
  vtkSetClampMacro(Mapping, int, Proximity, Overlap);
  vtkGetMacro(Mapping, int);
  ///@}

  ///@{
  /// With Mapping Overlap: the share of the smaller region that two must have in common. Default
  /// 0.1.
  vtkSetClampMacro(OverlapThreshold, double, 0.0, 0.999999);
  vtkGetMacro(OverlapThreshold, double);
  ///@}

  ///@{
  /**
   * Pairs of contours on adjacent levels (by the ContourId of vtkContourHierarchy) whose regions
   * are joined, or not joined, whatever the mapping says. Forbidding wins over forcing.
   */
  void AddForcedJoin(int contour, int otherContour);
  void RemoveAllForcedJoins();
  void AddForbiddenJoin(int contour, int otherContour);
  void RemoveAllForbiddenJoins();
  ///@}

  ///@{
  /**
   * Levels further apart than this many times the spacing beside them are not joined, with a line in
   * `Report`; 0: all are. Default 5: a few skipped slices are bridged (the widest gap in one shape
   * of the sets that the project is tested on is 3), two stacks of one name are not.
   */
  vtkSetClampMacro(MaximumGap, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumGap, double);
  ///@}

  ///@{
  /**
   * Shift levels onto one another before they are joined, and the surface back: for oblique shapes
   * whose sections hardly overlap (blades, swept wings, thin tubes, oblique shafts). 0: off; 1
   * (default): where two neighbouring levels have one outer contour each, of comparable size, these
   * share less than half of the smaller one, and the line through their centroids leans less than
   * 45 degrees; 2: wherever two neighbouring levels have one outer contour each. A forced join of the only
   * outer contours of two levels shifts these in any case.
   */
  vtkSetClampMacro(AlignLevels, int, 0, 2);
  vtkGetMacro(AlignLevels, int);
  ///@}

  ///@{
  /**
   * How the surface ends above a contour that has no partner: Flat in its plane, HalfSlice
   * straight on, Tapered, or NoCaps, open. Tapered also rounds off a part of a contour that ends
   * although the rest goes on. It is the default because it is nearest to the truth (see
   * Data/TRUTH.md). The volume that the caps add is in the field data `EndCapVolume`.
   */
  vtkSetClampMacro(EndCaps, int, Flat, NoCaps);
  vtkGetMacro(EndCaps, int);
  ///@}

  ///@{
  /**
   * A contour without partner on both sides: Extrude (default) by half a slice each way
   * (`IsolatedVolume`, and `Report` counts them), or Drop, with a line in `Report`.
   */
  vtkSetClampMacro(IsolatedContours, int, Drop, Extrude);
  vtkGetMacro(IsolatedContours, int);
  ///@}

  ///@{
  /// Number of threads; 0, the default, takes all of the machine. The result does not depend on it.
  vtkSetClampMacro(Threads, int, 0, 1024);
  vtkGetMacro(Threads, int);
  ///@}

  /**
   * Optional second input: a vtkTable whose columns `LowerContour`, `UpperContour` and `Join` (1
   * force, 0 forbid) add to the forced and forbidden joins; the table that Contour Mapping gives
   * will do, as it is or edited. Contours that come from Contour Mapping bring its decisions along:
   * they are followed, with a line in `Report`, but for pairs that are forced or forbidden here.
   */
  void SetOverridesConnection(vtkAlgorithmOutput* overrides);

protected:
  vtkPolyhedralAlgorithm();
  ~vtkPolyhedralAlgorithm() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  /**
   * The properties, the overrides (the second input, or nullptr), and the mapping that came with
   * the contours, about which there is a line in report then.
   *
   * @throws recon::Error for a table that is none of overrides
   */
  recon::PolyhedralOptions GetOptions(vtkPolyData* input, const recon::ContourSet& contours,
    vtkTable* overrides, std::vector<std::string>& report) const;

private:
  vtkPolyhedralAlgorithm(const vtkPolyhedralAlgorithm&) = delete;
  void operator=(const vtkPolyhedralAlgorithm&) = delete;

  bool InternalPoints = true;
  bool LiftInternalPoints = true;
  int Mapping = Overlap;
  double OverlapThreshold = 0.1;
  std::vector<std::pair<int, int>> ForcedJoins;
  std::vector<std::pair<int, int>> ForbiddenJoins;
  double MaximumGap = 5.0;
  int AlignLevels = 1;
  int EndCaps = Tapered;
  int IsolatedContours = Extrude;
  int Threads = 0;
};

#endif
