// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Constraints/DrawnPlanesFit.h"

#include "Base/NamedMonitor.h"
#include "Base/Text.h"
#include "Implicit/Constraints/DrawnCounts.h"
#include "Implicit/Constraints/DrawnSections.h"
#include "Implicit/Constraints/NearConstraints.h"
#include "Implicit/ZeroSet/Polygonizer.h"

#include <algorithm>

namespace recon
{
namespace
{
class DrawnPlanesFit
{
public:
  DrawnPlanesFit(const ContourSet& drawn, const ConstraintOptions& constraintOptions,
    const FunctionOptions& functionOptions, ContourFit& fit)
    : Result(fit),
      Function(functionOptions),
      Drawn(drawn),
      Cell(ChooseCellSize(PlacesOf(drawn), 0)),
      Sections(drawn, constraintOptions.EmptyPlanes, Cell, constraintOptions.Sections),
      MostPlaces(drawn.Points.size() + PlacesPerLevel * drawn.Levels.size())
  {
  }

  void Run(Monitor& monitor)
  {
    ConstraintSet asked = this->Result.Constraints;
    std::size_t added = 0;
    DrawnSections::Disagreements wrong = this->Compare(0, monitor);
    const std::size_t before = wrong.Sections.size();
    for (int round = 0; round < MostRounds && !wrong.Places.empty() && added < this->MostPlaces;
         ++round)
    {
      KeepDeepest(wrong.Places, this->MostPlaces - added);
      for (const ToldPlace& place : wrong.Places)
      {
        asked.Points.push_back(place.Place);
        asked.Values.push_back(place.Value);
        asked.Kind.push_back(place.Value > 0 ? ConstraintSet::Inner
            : place.Value < 0                ? ConstraintSet::Outer
                                             : ConstraintSet::Boundary);
        asked.Contour.push_back(-1);
      }
      added += wrong.Places.size();
      NamedMonitor fitting =
        NamedMonitor::Pass(monitor, round, MostRounds, "following the drawn planes");
      this->Fit(asked, fitting);
      wrong = this->Compare(round + 1, fitting);
    }
    this->Say(added, before, wrong);
    this->SayOtherCounts(monitor);
  }

private:
  static constexpr int MostRounds = 6; ///< of adding and fitting; stops earlier where all agree
  /// Beside one a contour point: what a contour of a few corners needs for straight edges.
  static constexpr std::size_t PlacesPerLevel = 300;
  static constexpr std::size_t MostNamed = 3;

  static std::vector<Point3> PlacesOf(const ContourSet& contours)
  {
    std::vector<Point3> places;
    for (const Contour& contour : contours.Contours)
    {
      for (const int p : contour.Points)
      {
        places.push_back(contours.Points[p]);
      }
    }
    return places;
  }

  static void KeepDeepest(std::vector<ToldPlace>& places, std::size_t count)
  {
    if (places.size() > count)
    {
      std::stable_sort(places.begin(), places.end(),
        [](const ToldPlace& a, const ToldPlace& b) { return a.Room > b.Room; });
      places.resize(count);
    }
  }

  DrawnSections::Disagreements Compare(int look, Monitor& monitor) const
  {
    return this->Sections.Compare(this->Result.Function, this->Function.Threads, monitor, look);
  }

  void Fit(const ConstraintSet& asked, Monitor& monitor)
  {
    ConstraintSet set = asked;
    set.Report.clear();
    ResolveNearConstraints(set);
    this->Result.Function = FitImplicitFunction(set.Points, set.Values, this->Function, monitor);
    set.Report = this->Result.Constraints.Report;
    this->Result.Constraints = std::move(set);
  }

  void Say(std::size_t added, std::size_t before, const DrawnSections::Disagreements& wrong)
  {
    std::vector<std::string>& report = this->Result.Constraints.Report;
    if (added > 0)
    {
      report.push_back(std::to_string(added) +
        " constraints were added, because the function was on another side "
        "than what was drawn on or between planes, at " +
        std::to_string(before) + " heights.");
    }
    if (!wrong.Sections.empty())
    {
      std::vector<std::string> names;
      for (const int section : wrong.Sections)
      {
        names.push_back(this->Sections.NameOf(section));
      }
      report.push_back("The surface still differs from what was drawn at " +
        Listed(names, MostNamed) +
        " along the stack: choose a smaller CellSize to see how, or draw "
        "what lies between.");
    }
  }

  std::vector<OtherCount> OtherCounts(Monitor& monitor)
  {
    try
    {
      AbortMonitor stop(monitor);
      return FindOtherCounts(this->Drawn, this->Result.Function, PlacesOf(this->Result.Contours),
        this->Cell, this->Function.Threads, stop);
    }
    catch (const Error& error)
    {
      // What there is to say is no reason to have no surface.
      this->Result.Constraints.Report.push_back(
        std::string("The number of contours on drawn planes was not looked at: ") + error.what());
      return {};
    }
  }

  void SayOtherCounts(Monitor& monitor)
  {
    const std::vector<OtherCount> others = this->OtherCounts(monitor);
    std::vector<std::string> names;
    for (const OtherCount& other : others)
    {
      names.push_back(Text(other.Height) + " (" + std::to_string(other.Drawn) + " drawn, " +
        std::to_string(other.Traced) + " there)");
    }
    if (!names.empty())
    {
      this->Result.Constraints.Report.push_back(
        "The surface has another number of contours than was drawn at " + Listed(names, MostNamed) +
        " along the stack: those with a thin wall between them grow together there, or a thin neck "
        "parts. Polyhedral Surface keeps both.");
    }
  }

  ContourFit& Result;
  const FunctionOptions& Function;
  const ContourSet& Drawn;
  const double Cell;
  const DrawnSections Sections;
  const std::size_t MostPlaces;
};
}

void FollowDrawnPlanes(const ContourSet& drawn, const ConstraintOptions& constraintOptions,
  const FunctionOptions& functionOptions, ContourFit& fit, Monitor& monitor)
{
  DrawnPlanesFit(drawn, constraintOptions, functionOptions, fit).Run(monitor);
}
}
