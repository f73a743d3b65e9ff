// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkContourSetAlgorithm
 * @brief How contours are read, which is the same in every filter that takes them.
 *
 * Input: vtkPolyData whose closed loops are polylines, polygons or loose two-point segments, in any
 * unit, order and sense of rotation. They are chained, closed, cleaned, grouped by planes and
 * nested before anything else is done with them.
 *
 * An empty input gives an empty output that says so in `Report`; so does a region of a structure
 * set that is points only. A surface, points without cells, and contours of which not one is usable
 * give an error.
 */
#ifndef vtkContourSetAlgorithm_h
#define vtkContourSetAlgorithm_h

#include "ContourFiltersModule.h" // for export macro
#include "vtkContourAlgorithm.h"

#include <string> // for std::string
#include <vector> // for std::vector

namespace recon
{
struct ContourSet;
class Monitor;
class Ranks;
}

class CONTOURFILTERS_EXPORT vtkContourSetAlgorithm : public vtkContourAlgorithm
{
public:
  vtkTypeMacro(vtkContourSetAlgorithm, vtkContourAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum HoleRuleType
  {
    Automatic = 0,
    EvenOdd = 1,
    Winding = 2,
    Keyhole = 3
  };

  ///@{
  /**
   * Which contours of a plane are walls of holes.
   *
   * - Automatic, the default: even-odd on every plane. It is right for holes that are drawn in
   *   either direction, for CLOSEDPLANAR_XOR contours and for keyholes, whatever mixture of them a
   *   file has; directions are not trusted, since most systems store them at random.
   * - EvenOdd: a place inside an odd number of contours is solid.
   * - Winding: a place that the contours wind around, in the direction in which they are given, is
   *   solid (nonzero rule): contours within contours of the same direction are no holes, and
   *   contours of the same direction that overlap are united. The direction of loose segments is
   *   that of the first of a chain.
   * - Keyhole, DICOM's own reading of CLOSED_PLANAR: every contour is solid, holes are only those
   *   that a contour itself walks around by a bridge, and the contours of a plane are united.
   *
   * Planes with CLOSEDPLANAR_XOR contours (cell array `GeometricType`) go by even-odd always.
   */
  vtkSetClampMacro(HoleRule, int, Automatic, Keyhole);
  vtkGetMacro(HoleRule, int);
  ///@}

  ///@{
  /**
   * Planes nearer to each other than this, in the unit of the input, are one level, with a line in
   * `Report`; 0, the default, finds the distance from the contours (5% of the median distance of
   * neighbouring planes, and at most 0.1 mm in DICOM data). Contours may be off their plane by as
   * much, too, or by what recon::ContourSetOptions::PlaneTolerance says. Levels that an earlier
   * filter of this plugin has found stay as they are.
   */
  vtkSetClampMacro(PlaneTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(PlaneTolerance, double);
  ///@}

  ///@{
  /**
   * In a plane, points and edges that are nearer than this become one, and slivers that are narrower
   * vanish; in the units of the input. 0, the default: a ten millionth of each contour's diagonal.
   * Outlines that are stored twice with other decimals, or traced twice, are one contour at any
   * setting. What either changes has a line in `Report`.
   */
  vtkSetClampMacro(SnapTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SnapTolerance, double);
  ///@}

  enum OpenLinesType
  {
    LeaveOut = 0,
    Chord = 1,
    Border = 2
  };

  ///@{
  /**
   * What becomes of open lines. Those whose ends are no farther apart than their points are always
   * closed, with a line in `Report`; LeaveOut, the default, leaves the others out, and warns where
   * they are most; Chord closes them by a straight line; Border along the border of the rectangle
   * around all contours, as isolines that leave their window ask for (parallel planes only).
   */
  vtkSetClampMacro(OpenLines, int, LeaveOut, Border);
  vtkGetMacro(OpenLines, int);
  ///@}

protected:
  vtkContourSetAlgorithm() = default;
  ~vtkContourSetAlgorithm() override = default;

  /**
   * Clean contours of the input by the properties above. What the input's own Report says, and what
   * of it can be no contour, comes first in their Report.
   *
   * Shows ContourSet::Warning as a warning.
   *
   * @param parallel whether contours of other planes than most are left out
   * @throws recon::Error, recon::Aborted
   */
  recon::ContourSet ReadContours(vtkPolyData* input, bool parallel, recon::Monitor& monitor);

  /**
   * The same for filters that make a solid. The blocks of a collection that lie in a plane each are
   * slices of one object: the first block becomes all of it, with a line in Report, the others
   * nothing.
   */
  recon::ContourSet ReadContoursOfSolid(vtkPolyData* input, bool parallel, recon::Monitor& monitor);

  /// Where an input is looked at as a whole, before the blocks of a collection come one by one.
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkContourSetAlgorithm(const vtkContourSetAlgorithm&) = delete;
  void operator=(const vtkContourSetAlgorithm&) = delete;

  /// What ranks have to agree about, before any of them works.
  void LookAtRanks(vtkDataObject* input, const recon::Ranks& ranks);

  /// Blocks of the collection that are still to come in.
  std::vector<vtkPolyData*> Pending;
  /// Why contours are not whole on this rank; empty where they are.
  std::string Spread;
  /// Of the collection whose blocks come in; empty where they are regions of their own.
  std::vector<vtkPolyData*> Slices;
  int HoleRule = Automatic;
  int OpenLines = LeaveOut;
  double PlaneTolerance = 0;
  double SnapTolerance = 0;
};

#endif
