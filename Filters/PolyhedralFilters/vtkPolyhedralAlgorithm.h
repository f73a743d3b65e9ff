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
#include "vtkContourJoinAlgorithm.h"

#include <string> // for std::string
#include <vector> // for std::vector

class vtkTable;

namespace recon
{
struct PolyhedralOptions;
}

class POLYHEDRALFILTERS_EXPORT vtkPolyhedralAlgorithm : public vtkContourJoinAlgorithm
{
public:
  vtkTypeMacro(vtkPolyhedralAlgorithm, vtkContourJoinAlgorithm);
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
    NoCaps = 3,
    Extrapolated = 4
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
  /**
   * How the surface ends above a contour that has no partner: Flat in its plane, HalfSlice
   * straight on, Tapered, Extrapolated as the sections before it tell, or NoCaps, open. Tapered and
   * Extrapolated also round off a part of a contour that ends although the rest goes on. Tapered is
   * the default (see Data/TRUTH.md). The volume that the caps add is in the field data `EndCapVolume`.
   */
  vtkSetClampMacro(EndCaps, int, Flat, Extrapolated);
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

protected:
  vtkPolyhedralAlgorithm() = default;
  ~vtkPolyhedralAlgorithm() override = default;

  /**
   * The properties, the overrides (the second input, or nullptr), and the mapping that came with
   * the contours, about which there is a line in report then: contours that come from Contour Mapping
   * bring its decisions along, which are followed but for pairs that are forced or forbidden here.
   *
   * @throws recon::Error for a table that is none of overrides
   */
  recon::PolyhedralOptions GetOptions(vtkPolyData* input, const recon::ContourSet& contours,
    vtkTable* overrides, std::vector<std::string>& report);

  /**
   * Puts into the options the joins that meet ExpectedPieces and ExpectedHandles, for nodes that show
   * a stage of the surface; returns the progress from which they go on: `from` where nothing is asked.
   */
  double MeetContract(
    const recon::ContourSet& contours, double from, recon::PolyhedralOptions& options);

private:
  vtkPolyhedralAlgorithm(const vtkPolyhedralAlgorithm&) = delete;
  void operator=(const vtkPolyhedralAlgorithm&) = delete;

  bool InternalPoints = true;
  bool LiftInternalPoints = true;
  int Mapping = Overlap;
  int EndCaps = Tapered;
  int IsolatedContours = Extrude;
};

#endif
