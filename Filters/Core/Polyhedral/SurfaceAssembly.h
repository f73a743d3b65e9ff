// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SurfaceAssembly.h
 * @brief The boundary of the solid of a stack, put together from parts of it as they are finished.
 *
 * A part is some neighbouring slabs, looked at together with one slab more on either side: where faces meet at a point
 * or an edge of their levels is seen then. Faces and points get the numbers that they have where the whole
 * stack is looked at at once, so where one part ends and the next begins shows nowhere. What comes last there waits:
 * cells beyond the first and the last level, pyramids, and edges that are halved.
 */
#ifndef recon_SurfaceAssembly_h
#define recon_SurfaceAssembly_h

#include "Base/Monitor.h"
#include "Contours/ContourSet.h"
#include "Polyhedral/FaceGroups.h"
#include "Polyhedral/PolyhedralSurface.h"
#include "Polyhedral/SurfacePart.h"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace recon
{
struct AssembledSurface
{
  PolyhedralSurface Surface;      ///< without Contract, Report and StageSeconds
  std::vector<char> IsPointExact; ///< by point, see PointOnSurface
};

class SurfaceAssembly
{
public:
  /// All must outlive this.
  SurfaceAssembly(const ContourSet& contours, const PolyhedralOptions& options, Monitor& monitor);

  /// Takes what it can of a stack of which the first so many levels are finished; see StagesSink. @throws Aborted
  std::size_t Add(const PolyhedralStages& stages, std::size_t levels);

  /// Once all levels have been added.
  AssembledSurface Finish();

private:
  /// A corner whose number is not known yet: one of a late face, or the middle of an edge.
  struct Corner
  {
    enum KindType : unsigned char
    {
      Numbered,
      Late,  ///< Number is one of LateFaces::Points
      Middle ///< Number is one of Middles
    };
    KindType Kind;
    int Number;
  };
  using Corners = std::array<Corner, 3>;

  /// A face in place of which there are pieces.
  struct SplitFace
  {
    std::size_t Face; ///< number of the face; of a late one, among the late ones of its kind
    std::vector<Corners> Pieces;
    std::vector<int> Groups;
  };

  /// Cells that come after those of all slabs: below the first level, above the last one, pyramids.
  struct LateFaces
  {
    std::vector<PointOnSurface> Points;
    std::vector<Corners> Faces;
    std::vector<int> Slab;
    std::vector<int> FaceKind;
    std::vector<int> Group;
    std::vector<int> Piece;                                         ///< from zero
    std::vector<std::pair<SolidComplex::PartType, double>> Volumes; ///< of cells
    std::vector<SplitFace> Splits;
    int Pieces = 0;
  };
  enum LateKind
  {
    BelowFirst,
    AboveLast,
    Pyramids,
    LateKinds
  };

  struct LateCell
  {
    LateKind Kind; ///< LateKinds: of another part
    int Piece;     ///< as in LateFaces
  };

  /// A face of the last slab that was added, by cell of the slab, and the numbers of its corners.
  struct KnownFace
  {
    int Cell;
    int Opposite;
    std::array<int, 3> Points;
  };

  void Reserve();
  void Append(const SurfacePart& part);
  std::vector<int> KnownNumbers(const SurfacePart& part) const;
  void RememberLastSlab(const SurfacePart& part, const std::vector<int>& numbers);
  void AppendFaces(const SurfacePart& part, std::vector<int>& numbers);
  std::vector<LateCell> TakeLateCells(const SurfacePart& part);
  void AppendLateFaces(const SurfacePart& part, const std::vector<int>& numbers);
  void AddVolume(SolidComplex::PartType kind, double volume);
  SplitFace SplitOf(const SurfacePart& part, std::size_t split, std::size_t face,
    const std::vector<int>& numbers, const std::vector<int>* late);
  void AddPoint(const PointOnSurface& point);
  void FinishLate(LateFaces& late);
  void FinishSplits();

  const ContourSet& Contours;
  const PolyhedralOptions& Options;
  Monitor& Observer;
  std::optional<FaceGroups> Groups;
  int NextSlab = 0;
  int Pieces = 0; ///< of the slabs so far
  std::vector<KnownFace> LastSlab;
  std::array<LateFaces, LateKinds> Late;
  std::vector<SplitFace> Splits;
  std::map<HalvedEdge, int> MiddleNumbers; ///< by edge, into Middles
  std::vector<PointOnSurface> Middles;
  AssembledSurface Result;
};
}

#endif
