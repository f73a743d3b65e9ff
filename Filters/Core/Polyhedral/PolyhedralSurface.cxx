// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/PolyhedralSurface.h"

#include "Base/Parallel.h"
#include "Base/SubMonitor.h"
#include "Base/Text.h"
#include "Mesh/CrossingRepair.h"
#include "Mesh/OutwardPieces.h"
#include "Mesh/PiecesAndHandles.h"
#include "Mesh/PinchGap.h"
#include "Mesh/SectionCuts.h"
#include "Mesh/SheetLinks.h"
#include "Polyhedral/FaceGroups.h"
#include "Polyhedral/KeptStages.h"
#include "Polyhedral/PinchedPoints.h"
#include "Polyhedral/PolyhedralStages.h"
#include "Polyhedral/SolidBoundary.h"
#include "Polyhedral/SolidComplex.h"
#include "Polyhedral/TopologyContract.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace recon
{
namespace
{
/// Share of the progress bar that the stages before the surface take.
constexpr double StagesShare = 0.85;

/// The same of the search for what a contract asks for, where there is one.
constexpr double SearchShare = 0.8;

/// Where points round, they may move so far that sheets do not cross, in median lengths of an edge:
/// no farther than what draws sheets apart.
constexpr double LargestNudge = 1e-3;

/// The solid's boundary with everything that the user may want to know about its faces and points.
class SurfaceWriter
{
public:
  SurfaceWriter(const ContourSet& contours, const PolyhedralOptions& options,
    const PolyhedralStages& stages, Monitor& monitor)
    : Contours(contours),
      Options(options),
      Stages(stages),
      Observer(monitor)
  {
  }

  /// solid: of the stages, of which the slabs may be gone.
  PolyhedralSurface Write(const SolidComplex& solid)
  {
    SolidBoundary boundary;
    std::vector<int> pieces;
    const auto examine = [&](int part)
    {
      if (part == 0)
      {
        boundary = ExtractSolidBoundary(solid);
      }
      else
      {
        pieces = FindPieces(solid);
      }
    };
    ParallelFor(
      2, this->Options.Threads, examine, this->Observer, { 0.9, 0.97, "extracting the surface" });
    this->CopyPoints(solid, boundary);
    this->CopyFaces(solid, boundary, pieces);
    this->MeasureCaps(solid);
    if (AsksForTopology(this->Options) && this->Options.EndCaps != PolyhedralOptions::NoCaps)
    {
      this->LinkPieces();
      this->CutHandles();
    }
    this->UndoCrossings();
    this->OpenPinches();
    this->Observer.Update(1, "extracting the surface");
    return std::move(this->Result);
  }

private:
  Point3 PositionOf(const SolidComplex::Vertex& vertex) const
  {
    const int source =
      vertex.Lifted ? -1 : this->Stages.Levels[vertex.Level].Triangulation.Source[vertex.Local];
    return source >= 0
      ? this->Contours.Points[source]
      : this->Contours.Levels[0].Frame.ToSpace(
          this->Stages.Alignment.Undo(vertex.Planar, vertex.Height), vertex.Height);
  }

  /// A lifted copy of a contour point is not the contour's.
  int KindOf(const SolidComplex::Vertex& vertex) const
  {
    return vertex.Lifted ? static_cast<int>(LevelTriangulation::Internal)
                         : this->Stages.Levels[vertex.Level].Triangulation.Kind[vertex.Local];
  }

  /// Whether the point that was decided on is the one that is given out, to the last bit.
  bool IsExact(const SolidComplex::Vertex& vertex, const Point3& position) const
  {
    return vertex.Local >= 0 && !this->PointsRound() &&
      position == this->Contours.Levels[0].Frame.ToSpace(vertex.Planar, vertex.Height);
  }

  void CopyPoints(const SolidComplex& solid, const SolidBoundary& boundary)
  {
    this->IsPointExact.reserve(boundary.Points.size());
    this->Result.Mesh.Points.reserve(boundary.Points.size());
    this->Result.PointKind.reserve(boundary.Points.size());
    for (const auto& point : boundary.Points)
    {
      const auto& vertex = solid.Vertices[point.Vertex];
      Point3 position = this->PositionOf(vertex);
      int kind = this->KindOf(vertex);
      this->IsPointExact.push_back(
        point.OtherVertex < 0 && this->IsExact(vertex, position) ? 1 : 0);
      if (point.OtherVertex >= 0)
      {
        position = 0.5 * (position + this->PositionOf(solid.Vertices[point.OtherVertex]));
        kind = LevelTriangulation::Internal;
      }
      this->Result.Mesh.Points.push_back(position);
      this->Result.PointKind.push_back(kind);
    }
  }

  /// All corners in the plane of one level, none lifted out of it.
  static bool LiesInPlane(
    const SolidComplex& solid, const SolidBoundary& boundary, const SolidBoundary::Face& face)
  {
    const int level = solid.Vertices[boundary.Points[face.Points[0]].Vertex].Level;
    const auto isOff = [&](int v)
    { return v >= 0 && (solid.Vertices[v].Lifted || solid.Vertices[v].Level != level); };
    for (int p : face.Points)
    {
      // The middle of a halved edge lies in the plane where both ends do.
      if (isOff(boundary.Points[p].Vertex) || isOff(boundary.Points[p].OtherVertex))
      {
        return false;
      }
    }
    return true;
  }

  void CopyFaces(
    const SolidComplex& solid, const SolidBoundary& boundary, const std::vector<int>& pieces)
  {
    const std::vector<int> groups =
      FindFaceGroups(this->Contours, this->Stages, solid, boundary, pieces);
    this->Result.Mesh.Triangles.reserve(boundary.Faces.size());
    for (std::vector<int>* ofTriangle : { &this->Result.Slab, &this->Result.FaceKind,
           &this->Result.MappingGroup, &this->Result.Piece })
    {
      ofTriangle->reserve(boundary.Faces.size());
    }
    int leftOpen = 0;
    for (std::size_t f = 0; f < boundary.Faces.size(); ++f)
    {
      const SolidBoundary::Face& face = boundary.Faces[f];
      const bool cap = LiesInPlane(solid, boundary, face);
      if (cap && this->Options.EndCaps == PolyhedralOptions::NoCaps)
      {
        ++leftOpen;
        continue;
      }
      this->Result.Mesh.Triangles.push_back(face.Points);
      this->Result.Slab.push_back(solid.Cells[face.Cell].Slab);
      this->Result.FaceKind.push_back(cap ? PolyhedralSurface::Cap : PolyhedralSurface::Wall);
      this->Result.MappingGroup.push_back(groups[f]);
      this->Result.Piece.push_back(pieces[face.Cell]);
    }
    if (this->Options.EndCaps == PolyhedralOptions::NoCaps)
    {
      this->Result.Report.push_back("The surface is open: EndCaps is None, so " +
        std::to_string(leftOpen) + " triangles in the planes of ends were left out.");
      for (int original : CutPinchedPoints(this->Result.Mesh))
      {
        this->Result.PointKind.push_back(this->Result.PointKind[original]);
        this->IsPointExact.push_back(this->IsPointExact[original]);
      }
    }
  }

  std::vector<double> Offsets() const
  {
    std::vector<double> offsets;
    for (const Level& level : this->Contours.Levels)
    {
      offsets.push_back(level.Offset);
    }
    return offsets;
  }

  /// What a triangle was made of tells what it is.
  void RelabelTriangles(const std::vector<int>& partOf)
  {
    for (std::vector<int>* ofTriangle : { &this->Result.Slab, &this->Result.FaceKind,
           &this->Result.MappingGroup, &this->Result.Piece })
    {
      const std::vector<int> before = *ofTriangle;
      ofTriangle->clear();
      for (const int whole : partOf)
      {
        ofTriangle->push_back(before[static_cast<std::size_t>(whole)]);
      }
    }
    this->Result.PointKind.resize(this->Result.Mesh.Points.size(), LevelTriangulation::Internal);
    // Triangles that were not decided with the tetrahedra may cross, wherever their corners are.
    this->IsPointExact.clear();
  }

  /// Where there are still more pieces, or fewer handles, than asked for.
  void LinkPieces()
  {
    const PiecesAndHandles count = CountPiecesAndHandles(this->Result.Mesh);
    const int pieces = this->Options.ExpectedPieces;
    const LinksWanted wanted{ pieces < 0 ? 0 : std::max(0, count.Pieces - pieces),
      std::max(0, this->Options.ExpectedHandles - count.Handles) };
    if (wanted.Pieces + wanted.Handles == 0)
    {
      return;
    }
    const SheetLinks links = LinkSheets(
      this->Result.Mesh, this->Contours.Levels[0].Frame, this->Offsets(), wanted, this->Observer);
    double longest = 0;
    for (const SheetLink& link : links.Links)
    {
      const double length = Norm(link.To - link.From);
      longest = std::max(longest, length);
      this->Result.Contract.push_back(
        { link.ThroughSolid ? ContractDecision::Tunnel : ContractDecision::Join, link.Slab,
          this->NearestContour(link.Slab, link.From), this->NearestContour(link.Slab + 1, link.To),
          length });
    }
    this->RelabelTriangles(links.PartOf);
    if (!links.Links.empty())
    {
      this->Result.Report.push_back(Counted(links.Links.size(), "thin straight tube") +
        ", at most " + Text(longest) +
        " long, made for ExpectedPieces and ExpectedHandles: no slice shows what holds these "
        "pieces "
        "together, so where it is and how wide is made up.");
    }
  }

  /// Where there are more handles than asked for.
  void CutHandles()
  {
    const int tooMany = this->Options.ExpectedHandles < 0
      ? 0
      : HandlesTooMany(this->Options, CountPiecesAndHandles(this->Result.Mesh));
    if (tooMany == 0)
    {
      return;
    }
    const SectionCuts cuts = recon::CutHandles(
      this->Result.Mesh, this->Contours.Levels[0].Frame, this->Offsets(), tooMany, this->Observer);
    for (const SectionCut& cut : cuts.Cuts)
    {
      this->Result.Contract.push_back({ cut.Solid ? ContractDecision::Cut : ContractDecision::Fill,
        cut.Slab, this->NearestContour(cut.Slab, cut.Place),
        this->NearestContour(cut.Slab + 1, cut.Place), cut.Area });
    }
    this->RelabelTriangles(cuts.PartOf);
  }

  /// By its vertices: for a sentence.
  int NearestContour(int level, const Point3& place) const
  {
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    for (const int contour : this->Contours.Levels[level].Contours)
    {
      for (const int p : this->Contours.Contours[contour].Points)
      {
        const double distance = Norm(this->Contours.Points[p] - place);
        if (distance < least)
        {
          least = distance;
          nearest = contour;
        }
      }
    }
    return nearest;
  }

  /// Whether points of space differ from those in whose coordinates the topology was decided.
  bool PointsRound() const
  {
    return this->Contours.Levels[0].Grid > 0 || !this->Stages.Alignment.IsEmpty();
  }

  bool AreAllExact() const
  {
    return this->IsPointExact.size() == this->Result.Mesh.Points.size() &&
      std::count(this->IsPointExact.begin(), this->IsPointExact.end(), 0) == 0;
  }

  void UndoCrossings()
  {
    if (this->AreAllExact())
    {
      return;
    }
    CrossingRepairOptions repair;
    repair.IsExact = this->IsPointExact;
    this->TypicalEdge = MedianEdgeLength(this->Result.Mesh);
    repair.Reach = LargestNudge * *this->TypicalEdge;
    repair.Frame = this->Contours.Levels[0].Frame;
    repair.Threads = this->Options.Threads;
    for (int kind : this->Result.PointKind)
    {
      repair.MayMove.push_back(kind != LevelTriangulation::InputVertex ? 1 : 0);
    }
    const CrossingRepairResult repaired =
      recon::UndoCrossings(this->Result.Mesh, repair, this->Observer);
    for (int whole : repaired.PartOf)
    {
      this->Result.Slab.push_back(this->Result.Slab[whole]);
      this->Result.FaceKind.push_back(this->Result.FaceKind[whole]);
      this->Result.MappingGroup.push_back(this->Result.MappingGroup[whole]);
      this->Result.Piece.push_back(this->Result.Piece[whole]);
    }
    this->Result.PointKind.resize(this->Result.Mesh.Points.size(), LevelTriangulation::Internal);
    if (repaired.Found > 0)
    {
      this->Result.Report.push_back("Rounding of points made the surface cross itself in " +
        Counted(repaired.Found, "pair") + " of triangles; " + Counted(repaired.Moved, "point") +
        ", none of a contour, moved by at most " + Text(repaired.Farthest) +
        (repaired.Left > 0 ? ", but " + Counted(repaired.Left, "pair") + " still " +
              (repaired.Left == 1 ? "does." : "do.")
                           : std::string(", so that it does not.")));
    }
    if (repaired.Found > 0)
    {
      this->TypicalEdge.reset();
    }
    const bool mayTurn = this->PointsRound() || repaired.Found > 0;
    const std::size_t turned = mayTurn ? TurnThinPiecesOutward(this->Result.Mesh, repair.Reach) : 0;
    if (turned > 0)
    {
      this->Result.Report.push_back(Counted(turned, "piece") +
        " of the surface, as thin as points are rounded, came out inside out and " +
        (turned == 1 ? "was" : "were") + " turned over.");
    }
  }

  void OpenPinches()
  {
    if (!(this->Options.PinchGap > 0))
    {
      return;
    }
    const double gap = this->Options.PinchGap *
      (this->TypicalEdge ? *this->TypicalEdge : MedianEdgeLength(this->Result.Mesh));
    const PinchGapResult pinches = recon::OpenPinches(
      this->Result.Mesh, gap, this->Contours.Levels[0].Frame.Normal, this->Observer);
    if (pinches.Places > 0)
    {
      this->Result.Report.push_back("Sheets of the surface touched in " +
        Counted(pinches.Places, "place") + " and were drawn apart by at most " + Text(gap) +
        (pinches.Left > 0
            ? ", but in " + Counted(pinches.Left, "place") + " no way apart was found."
            : std::string(".")));
    }
  }

  static double VolumeOf(const SolidComplex& solid, const SolidComplex::Cell& cell)
  {
    const auto at = [&](int k)
    {
      const auto& v = solid.Vertices[cell.Vertices[k]];
      return Point3{ v.Planar[0], v.Planar[1], v.Height };
    };
    return Dot(at(1) - at(0), Cross(at(2) - at(0), at(3) - at(0))) / 6;
  }

  void MeasureCaps(const SolidComplex& solid)
  {
    for (const auto& cell : solid.Cells)
    {
      if (cell.Part == SolidComplex::EndCap)
      {
        this->Result.EndCapVolume += VolumeOf(solid, cell);
      }
      else if (cell.Part == SolidComplex::Isolated)
      {
        this->Result.IsolatedVolume += VolumeOf(solid, cell);
      }
    }
  }

  const ContourSet& Contours;
  const PolyhedralOptions& Options;
  const PolyhedralStages& Stages;
  Monitor& Observer;
  std::vector<char>
    IsPointExact; ///< see IsExact; points that were computed from others are not; empty: none is
  std::optional<double>
    TypicalEdge; ///< MedianEdgeLength of the mesh where it is known as it is now
  PolyhedralSurface Result;
};

PolyhedralSurface BuildAsMapped(const ContourSet& contours, const PolyhedralOptions& options,
  Monitor& monitor, TetrahedraWanted wanted, KeptStages* kept)
{
  PolyhedralStages own;
  if (!kept)
  {
    own = BuildPolyhedralStages(contours, options, monitor, StagesShare, wanted);
  }
  const PolyhedralStages& stages =
    kept ? kept->Update(contours, options, monitor, StagesShare, wanted) : own;
  const auto start = std::chrono::steady_clock::now();
  monitor.Update(StagesShare, "extracting the surface");
  const SolidComplex solid = BuildSolidComplex(stages.Levels, stages.Slabs);
  own.Slabs = {}; // as much again as the complex
  PolyhedralSurface surface = SurfaceWriter(contours, options, stages, monitor).Write(solid);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  surface.Report.insert(surface.Report.begin(), stages.Report.begin(), stages.Report.end());
  surface.StageSeconds = stages.StageSeconds;
  surface.StageSeconds.emplace_back("extract surface", seconds.count());
  if (kept)
  {
    kept->ForgetIfLarge();
  }
  return surface;
}
}

PolyhedralSurface BuildPolyhedralSurface(const ContourSet& contours,
  const PolyhedralOptions& options, Monitor& monitor, TetrahedraWanted wanted, KeptStages* kept)
{
  if (!AsksForTopology(options))
  {
    return BuildAsMapped(contours, options, monitor, wanted, kept);
  }
  const auto start = std::chrono::steady_clock::now();
  SubMonitor searching(monitor, 0, SearchShare);
  const MetContract met = MeetContract(contours, options, searching);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  PolyhedralOptions asked = options;
  asked.Contract = met.Decisions;
  SubMonitor building(monitor, SearchShare, 1);
  PolyhedralSurface surface = BuildAsMapped(contours, asked, building, wanted, nullptr);
  surface.Contract.insert(surface.Contract.begin(), met.Decisions.begin(), met.Decisions.end());
  surface.Report.push_back(DescribeContract(
    contours, options, met, surface.Contract, CountPiecesAndHandles(surface.Mesh)));
  surface.StageSeconds.emplace_back("meet the contract", seconds.count());
  return surface;
}
}
