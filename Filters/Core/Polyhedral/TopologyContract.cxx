// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/TopologyContract.h"

#include "Base/SubMonitor.h"
#include "Base/Text.h"
#include "Contours/JoinExplanation.h"
#include "Mesh/TriangleComponents.h"
#include "Polyhedral/ContractCandidates.h"
#include "Polyhedral/PolyhedralStages.h"
#include "Polyhedral/SolidBoundary.h"
#include "Polyhedral/SolidComplex.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <set>
#include <tuple>
#include <utility>

namespace recon
{
namespace
{
/// Surfaces that are built at most in search of a contract; the counts of the sets at hand are met
/// with fewer than half.
constexpr int MostTrials = 200;

/// Candidates that are tried at once at most; those that do less than they should are halved.
constexpr std::size_t MostAtOnce = 16;

/// A surface without its geometry: what is joined, and what that makes of it.
struct Trial
{
  std::vector<ContractDecision> Decisions;
  PolyhedralStages Stages;
  PiecesAndHandles Count;
  std::vector<int> PieceOfContour;
};

std::string Named(const PiecesAndHandles& count)
{
  return Counted(static_cast<std::size_t>(count.Pieces), "piece") + " and " +
    Counted(static_cast<std::size_t>(count.Handles), "handle");
}

std::string AskedWords(const PolyhedralOptions& options)
{
  std::vector<std::string> words;
  if (options.ExpectedPieces >= 0)
  {
    words.push_back("ExpectedPieces is " + std::to_string(options.ExpectedPieces));
  }
  if (options.ExpectedHandles >= 0)
  {
    words.push_back("ExpectedHandles is " + std::to_string(options.ExpectedHandles));
  }
  return Listed(words, 2);
}

/// How many pieces and handles there are more, or less, than asked for.
struct Excess
{
  int Pieces = 0;
  int Handles = 0;

  int Size() const { return std::abs(this->Pieces) + std::abs(this->Handles); }
};

Excess ExcessOf(const PolyhedralOptions& options, const PiecesAndHandles& count)
{
  return { options.ExpectedPieces < 0 ? 0 : count.Pieces - options.ExpectedPieces,
    options.ExpectedHandles < 0 ? 0 : count.Handles - options.ExpectedHandles };
}

class Search
{
public:
  Search(const ContourSet& contours, const PolyhedralOptions& options, Monitor& monitor)
    : Contours(contours),
      Options(options),
      Observer(monitor)
  {
  }

  MetContract Run()
  {
    Trial best = this->Try({});
    MetContract met;
    met.Untold = best.Count;
    while (this->WantingOf(best) > 0 && this->Improve(best))
    {
    }
    met.Decisions = best.Decisions;
    met.IsExhausted = this->Trials >= MostTrials;
    return met;
  }

private:
  /// Handles too many are not wanting: they are cut off afterwards.
  int WantingOf(const Trial& trial) const
  {
    const Excess excess = ExcessOf(this->Options, trial.Count);
    return std::abs(excess.Pieces) + std::max(0, -excess.Handles);
  }

  Trial Try(std::vector<ContractDecision> decisions)
  {
    ++this->Trials;
    this->Observer.Update(static_cast<double>(this->Trials) / (MostTrials + 1),
      "looking for what the contract asks for");
    Trial trial;
    trial.Decisions = std::move(decisions);
    this->Options.Contract = trial.Decisions;
    AbortMonitor stop(this->Observer);
    trial.Stages = BuildPolyhedralStages(this->Contours, this->Options, stop);
    this->Count(trial);
    return trial;
  }

  void Count(Trial& trial) const
  {
    const SolidComplex solid = BuildSolidComplex(trial.Stages.Levels, trial.Stages.Slabs);
    const SolidBoundary boundary = ExtractSolidBoundary(solid);
    TriangleMesh mesh;
    mesh.Points.resize(boundary.Points.size());
    for (const SolidBoundary::Face& face : boundary.Faces)
    {
      mesh.Triangles.push_back(face.Points);
    }
    trial.Count = CountPiecesAndHandles(mesh);
    trial.PieceOfContour = this->PiecesOfContours(trial.Stages, solid, boundary, mesh);
  }

  std::vector<int> PiecesOfContours(const PolyhedralStages& stages, const SolidComplex& solid,
    const SolidBoundary& boundary, const TriangleMesh& mesh) const
  {
    const TriangleComponents components = FindTriangleComponents(mesh);
    std::vector<std::vector<int>> pieceOfPoint;
    for (const LevelState& level : stages.Levels)
    {
      pieceOfPoint.emplace_back(level.Triangulation.Points.size(), -1);
    }
    for (std::size_t f = 0; f < boundary.Faces.size(); ++f)
    {
      for (const int p : boundary.Faces[f].Points)
      {
        const SolidComplex::Vertex& vertex = solid.Vertices[boundary.Points[p].Vertex];
        if (!vertex.Lifted && boundary.Points[p].OtherVertex < 0)
        {
          pieceOfPoint[vertex.Level][vertex.Local] = components.Of[f];
        }
      }
    }
    std::vector<int> pieces(this->Contours.Contours.size(), -1);
    for (std::size_t l = 0; l < stages.Levels.size(); ++l)
    {
      const LevelTriangulation& level = stages.Levels[l].Triangulation;
      for (std::size_t t = 0; t < level.Triangles.size(); ++t)
      {
        for (int k = 0; k < 3; ++k)
        {
          const int contour = level.EdgeContour[t][k];
          if (contour >= 0)
          {
            pieces[contour] = pieceOfPoint[l][level.Triangles[t][(k + 1) % 3]];
          }
        }
      }
    }
    return pieces;
  }

  /// What is of the kind that is wanting, the cheapest first, without what was tried in vain.
  std::vector<ContractStep> Wanted(const Trial& trial) const
  {
    const ContractCandidates all =
      FindContractCandidates(this->Contours, trial.Stages, trial.PieceOfContour);
    const Excess excess = ExcessOf(this->Options, trial.Count);
    std::vector<ContractStep> wanted;
    const auto add = [&](const std::vector<ContractStep>& from, int most)
    {
      for (const ContractStep& step : from)
      {
        if (most > 0 && this->InVain.count(KeyOf(step)) == 0)
        {
          wanted.push_back(step);
          --most;
        }
      }
    };
    // Pieces first: what holds them together may close a loop, too.
    add(all.Joining, excess.Pieces);
    add(all.Parting, -excess.Pieces);
    add(all.Looping, wanted.empty() ? -excess.Handles : 0);
    return wanted;
  }

  /// False where nothing more can be done.
  bool Improve(Trial& best)
  {
    const std::vector<ContractStep> wanted = this->Wanted(best);
    const int before = this->WantingOf(best);
    for (std::size_t count = std::min(wanted.size(), this->AtOnce); count > 0; count /= 2)
    {
      if (this->Trials >= MostTrials)
      {
        return false;
      }
      std::vector<ContractDecision> decisions = best.Decisions;
      for (std::size_t k = 0; k < count; ++k)
      {
        decisions.insert(decisions.end(), wanted[k].begin(), wanted[k].end());
      }
      Trial trial = this->Try(std::move(decisions));
      this->AtOnce = count;
      if (this->WantingOf(trial) + static_cast<int>(count) <= before)
      {
        this->AtOnce = std::min(MostAtOnce, 2 * count);
        best = std::move(trial);
        return true;
      }
    }
    if (wanted.empty())
    {
      return false;
    }
    this->InVain.insert(KeyOf(wanted.front()));
    return true;
  }

  using Key = std::tuple<int, int, int, int>;

  static Key KeyOf(const ContractStep& step)
  {
    const ContractDecision& first = step.front();
    return { first.Kind, first.Slab, first.Lower, first.Upper };
  }

  const ContourSet& Contours;
  PolyhedralOptions Options;
  Monitor& Observer;
  std::set<Key> InVain;
  std::size_t AtOnce = MostAtOnce;
  int Trials = 0;
};

std::string NameOf(const ContourSet& contours, int contour)
{
  return contour < 0 ? std::string()
                     : std::to_string(contour) + " (" +
      PlaceOf(contours.Levels[contours.Contours[contour].Level]) + ")";
}

std::string NameOfDecision(const ContourSet& contours, const ContractDecision& d)
{
  static const char* const verbs[] = { "joined", "parted", "opened to each other through solid",
    "parted in one place", "closed to each other in one place" };
  const std::string lower = NameOf(contours, d.Lower);
  const std::string upper = NameOf(contours, d.Upper);
  const bool both = !lower.empty() && !upper.empty();
  return std::string(both ? "contours " : "contour ") + lower + (both ? " and " : "") + upper +
    (both ? " are " : " is ") + verbs[d.Kind];
}

std::string WhyNotMet(const PolyhedralOptions& options, const Excess& left, bool isExhausted)
{
  if (options.EndCaps == PolyhedralOptions::NoCaps)
  {
    return "EndCaps is None, and an open surface has neither.";
  }
  if (isExhausted)
  {
    return "it was not found within " + std::to_string(MostTrials) +
      " surfaces; say with ForcedJoins and ForbiddenJoins what belongs together.";
  }
  if (left.Pieces > 0)
  {
    return "no contours of different pieces face each other on neighbouring levels, so what holds "
           "them together lies between two slices and would have to be made up; a slice through it "
           "would show it.";
  }
  if (left.Pieces < 0)
  {
    return "nothing is left that could be parted.";
  }
  return left.Handles > 0 ? "no section that was tried between two levels cuts through the others."
                          : "nothing is left that could be joined in a second place.";
}
}

bool AsksForTopology(const PolyhedralOptions& options)
{
  return options.ExpectedPieces != -1 || options.ExpectedHandles != -1;
}

MetContract MeetContract(
  const ContourSet& contours, const PolyhedralOptions& options, Monitor& monitor)
{
  if (options.ExpectedPieces < -1 || options.ExpectedPieces == 0 || options.ExpectedHandles < -1)
  {
    throw Error(
      "ExpectedPieces is 1 or more, ExpectedHandles 0 or more, and -1 leaves either free: "
      "instead of " +
      std::to_string(options.ExpectedPieces) + " and " + std::to_string(options.ExpectedHandles) +
      ".");
  }
  return options.EndCaps == PolyhedralOptions::NoCaps ? MetContract()
                                                      : Search(contours, options, monitor).Run();
}

int HandlesTooMany(const PolyhedralOptions& options, const PiecesAndHandles& found)
{
  return options.EndCaps == PolyhedralOptions::NoCaps
    ? 0
    : std::max(0, ExcessOf(options, found).Handles);
}

std::string DescribeContract(const ContourSet& contours, const PolyhedralOptions& options,
  const MetContract& met, const std::vector<ContractDecision>& decisions,
  const PiecesAndHandles& found)
{
  std::vector<std::string> changes;
  for (const ContractDecision& decision : decisions)
  {
    changes.push_back(NameOfDecision(contours, decision));
  }
  std::string text = AskedWords(options) + ": ";
  text += changes.empty() ? "the surface has " + Named(found)
                          : "instead of " + Named(met.Untold) + " the surface has " + Named(found) +
      ", as " + Listed(changes, 4);
  const Excess left = ExcessOf(options, found);
  const bool isMet = left.Size() == 0 && options.EndCaps != PolyhedralOptions::NoCaps;
  return text + "." +
    (isMet ? std::string()
           : " That is not what was asked for: " + WhyNotMet(options, left, met.IsExhausted));
}
}
