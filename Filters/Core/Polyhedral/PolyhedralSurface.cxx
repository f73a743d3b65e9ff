// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/PolyhedralSurface.h"

#include "Base/SubMonitor.h"
#include "Base/Text.h"
#include "Mesh/CrossingRepair.h"
#include "Mesh/OutwardPieces.h"
#include "Mesh/PiecesAndHandles.h"
#include "Mesh/PinchGap.h"
#include "Mesh/SectionCuts.h"
#include "Mesh/SheetLinks.h"
#include "Polyhedral/KeptStages.h"
#include "Polyhedral/PinchedPoints.h"
#include "Polyhedral/PolyhedralStages.h"
#include "Polyhedral/SurfaceAssembly.h"
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
constexpr double StagesShare = 0.97;

/// Progress when all of the surface is there.
constexpr double FinishedAt = StagesShare;

/// The same of the search for what a contract asks for, where there is one.
constexpr double SearchShare = 0.8;

/// Where points round, they may move so far that sheets do not cross, in median lengths of an edge:
/// no farther than what draws sheets apart.
constexpr double LargestNudge = 1e-3;

/// What is done to the surface once it is whole.
class SurfaceFinisher
{
public:
  SurfaceFinisher(const ContourSet& contours, const PolyhedralOptions& options,
    const PolyhedralStages& stages, Monitor& monitor)
    : Contours(contours),
      Options(options),
      Stages(stages),
      Observer(monitor)
  {
  }

  PolyhedralSurface Finish(AssembledSurface assembled)
  {
    this->Observer.Update(FinishedAt, "extracting the surface");
    this->Result = std::move(assembled.Surface);
    this->IsPointExact = std::move(assembled.IsPointExact);
    if (this->Options.EndCaps == PolyhedralOptions::NoCaps)
    {
      this->LeaveOpen();
    }
    else if (AsksForTopology(this->Options))
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
  void LeaveOpen()
  {
    std::vector<int> left;
    for (std::size_t t = 0; t < this->Result.FaceKind.size(); ++t)
    {
      if (this->Result.FaceKind[t] != PolyhedralSurface::Cap)
      {
        left.push_back(static_cast<int>(t));
      }
    }
    const std::size_t leftOpen = this->Result.FaceKind.size() - left.size();
    std::vector<std::array<int, 3>> triangles;
    triangles.reserve(left.size());
    for (const int t : left)
    {
      triangles.push_back(this->Result.Mesh.Triangles[t]);
    }
    this->Result.Mesh.Triangles = std::move(triangles);
    this->TakeLabelsOf(left);
    this->Result.Report.push_back("The surface is open: EndCaps is None, so " +
      std::to_string(leftOpen) + " triangles in the planes of ends were left out.");
    for (const int original : CutPinchedPoints(this->Result.Mesh))
    {
      this->Result.PointKind.push_back(this->Result.PointKind[original]);
      this->IsPointExact.push_back(this->IsPointExact[original]);
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

  /// Slab, FaceKind, MappingGroup and Piece of every triangle are those of an earlier one.
  void TakeLabelsOf(const std::vector<int>& earlier)
  {
    for (std::vector<int>* ofTriangle : { &this->Result.Slab, &this->Result.FaceKind,
           &this->Result.MappingGroup, &this->Result.Piece })
    {
      const std::vector<int> before = std::move(*ofTriangle);
      ofTriangle->clear();
      for (const int triangle : earlier)
      {
        ofTriangle->push_back(before[static_cast<std::size_t>(triangle)]);
      }
    }
  }

  /// What a triangle was made of tells what it is.
  void RelabelTriangles(const std::vector<int>& partOf)
  {
    this->TakeLabelsOf(partOf);
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

  const ContourSet& Contours;
  const PolyhedralOptions& Options;
  const PolyhedralStages& Stages;
  Monitor& Observer;
  std::vector<char>
    IsPointExact; ///< see PointOnSurface; points that were computed from others are not; empty: none is
  std::optional<double>
    TypicalEdge; ///< MedianEdgeLength of the mesh where it is known as it is now
  PolyhedralSurface Result;
};

PolyhedralSurface BuildAsMapped(const ContourSet& contours, const PolyhedralOptions& options,
  Monitor& monitor, TetrahedraWanted wanted, KeptStages* kept)
{
  SurfaceAssembly assembly(contours, options, monitor);
  std::chrono::duration<double> seconds{ 0 };
  const auto watched = [&](const auto& work)
  {
    const auto start = std::chrono::steady_clock::now();
    auto result = work();
    seconds += std::chrono::steady_clock::now() - start;
    return result;
  };
  const StagesSink sink = [&](const PolyhedralStages& stages, std::size_t levels)
  { return watched([&] { return assembly.Add(stages, levels); }); };
  PolyhedralStages own;
  if (!kept)
  {
    own = BuildPolyhedralStages(contours, options, monitor, StagesShare, wanted, false, sink);
  }
  const PolyhedralStages& stages =
    kept ? kept->Update(contours, options, monitor, StagesShare, wanted, sink) : own;
  PolyhedralSurface surface = watched(
    [&] { return SurfaceFinisher(contours, options, stages, monitor).Finish(assembly.Finish()); });
  surface.Report.insert(surface.Report.begin(), stages.Report.begin(), stages.Report.end());
  surface.StageSeconds = stages.StageSeconds;
  surface.StageSeconds.emplace_back("extract surface", seconds.count());
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
