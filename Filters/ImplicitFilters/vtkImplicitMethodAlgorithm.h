// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkImplicitMethodAlgorithm
 * @brief The properties of constraints, for the implicit method as a whole and for its first stage.
 */
#ifndef vtkImplicitMethodAlgorithm_h
#define vtkImplicitMethodAlgorithm_h

#include "ImplicitFiltersModule.h" // for the export macro
#include "vtkContourSetAlgorithm.h"

class IMPLICITFILTERS_EXPORT vtkImplicitMethodAlgorithm : public vtkContourSetAlgorithm
{
public:
  vtkTypeMacro(vtkImplicitMethodAlgorithm, vtkContourSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ModeType
  {
    Margins = 0,
    BoundingBoxCorners = 1
  };

  ///@{
  /**
   * Where constraints stand: Margins on both sides of every contour vertex (thesis 9.1, 3n in all),
   * or BoundingBoxCorners, the eight corners of the contours' bounding box as outside (thesis 10.3,
   * n + 8).
   */
  vtkSetClampMacro(Mode, int, Margins, BoundingBoxCorners);
  vtkGetMacro(Mode, int);
  ///@}

  enum ValuesType
  {
    Unit = 0,
    Distance = 1
  };

  ///@{
  /**
   * Unit: +1 inside, -1 outside (thesis). Distance, the default: signed distance to the contour,
   * which is nearer to the truth where the surface is oblique to the contours.
   */
  vtkSetClampMacro(Values, int, Unit, Distance);
  vtkGetMacro(Values, int);
  ///@}

  enum NormalsType
  {
    InPlane = 0,
    Refined = 1
  };

  ///@{
  /**
   * InPlane: margins in the contours' planes (thesis). Refined, the default: a first fit tells how
   * oblique the surface is to the planes, and margins are turned, or valued, by that, or reach
   * across steps, whichever predicts left-out slices best (ContourFit.h).
   */
  vtkSetClampMacro(Normals, int, InPlane, Refined);
  vtkGetMacro(Normals, int);
  ///@}

  ///@{
  /**
   * Distance of the margins, in the units of the input; 0, the default: a third of the median
   * contour edge.
   */
  vtkSetMacro(MarginDistance, double);
  vtkGetMacro(MarginDistance, double);
  ///@}

  ///@{
  /**
   * Let margins reach as far as the next slice, where that says otherwise of the place: for few
   * slices of a shape with flat ends or steps. Parallel planes and Values Distance only. Off, the
   * default: only where normals are Refined and left-out slices say that it is nearer to them.
   */
  vtkSetMacro(ReachAcrossSteps, bool);
  vtkGetMacro(ReachAcrossSteps, bool);
  vtkBooleanMacro(ReachAcrossSteps, bool);
  ///@}

  ///@{
  /**
   * Points of crossing planes that fit in a box of this part of the bounding box become their
   * centroid (thesis 9.1, which uses 0.05). 0, the default: none.
   */
  vtkSetMacro(MergeBox, double);
  vtkGetMacro(MergeBox, double);
  ///@}

  ///@{
  /**
   * Leave out contour points that stand closer than a quarter of the gap between the contours
   * (wider where there are very many), on by default; no point moves and corners stay. Without
   * effect where ResampleSpacing or ResampleTolerance is given.
   */
  vtkSetMacro(ThinOut, bool);
  vtkGetMacro(ThinOut, bool);
  vtkBooleanMacro(ThinOut, bool);
  ///@}

  ///@{
  /**
   * Put points on straight contour edges longer than twice the gap between the contours, on by
   * default: the function knows a contour at its points alone. Without effect where ResampleSpacing
   * or ResampleTolerance is given.
   */
  vtkSetMacro(FillLongEdges, bool);
  vtkGetMacro(FillLongEdges, bool);
  vtkBooleanMacro(FillLongEdges, bool);
  ///@}

  ///@{
  /**
   * Add constraints where the function is on another side than what was drawn, on by default: on
   * drawn planes, also where they are empty, and between two that say the same. For parallel planes
   * and values that are distances. Report tells how many, and where the surface still differs.
   */
  vtkSetMacro(FollowDrawnPlanes, bool);
  vtkGetMacro(FollowDrawnPlanes, bool);
  vtkBooleanMacro(FollowDrawnPlanes, bool);
  ///@}

  ///@{
  /**
   * Resample contours to about this distance between points first, in the units of the input; 0: do
   * not.
   */
  vtkSetMacro(ResampleSpacing, double);
  vtkGetMacro(ResampleSpacing, double);
  ///@}

  ///@{
  /**
   * Leave out contour points where the contour moves by less than this first, in the units of the
   * input; 0: do not.
   */
  vtkSetMacro(ResampleTolerance, double);
  vtkGetMacro(ResampleTolerance, double);
  ///@}

  ///@{
  /**
   * Number of threads; 0, the default, takes all of the machine. The result does not depend on it.
   */
  vtkSetClampMacro(Threads, int, 0, 1024);
  vtkGetMacro(Threads, int);
  ///@}

protected:
  vtkImplicitMethodAlgorithm() = default;
  ~vtkImplicitMethodAlgorithm() override = default;

private:
  vtkImplicitMethodAlgorithm(const vtkImplicitMethodAlgorithm&) = delete;
  void operator=(const vtkImplicitMethodAlgorithm&) = delete;

  int Mode = Margins;
  int Values = Distance;
  int Normals = Refined;
  double MarginDistance = 0.0;
  bool ReachAcrossSteps = false;
  double MergeBox = 0.0;
  bool ThinOut = true;
  bool FillLongEdges = true;
  bool FollowDrawnPlanes = true;
  double ResampleSpacing = 0.0;
  double ResampleTolerance = 0.0;
  int Threads = 0;
};

#endif
