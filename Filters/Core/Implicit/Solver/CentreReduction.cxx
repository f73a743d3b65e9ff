// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Solver/CentreReduction.h"

#include "Base/SubMonitor.h"
#include "Implicit/FastMultipole/FunctionEvaluator.h"
#include "Implicit/Solver/MaximinOrder.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace recon
{
namespace
{
/// Constraints to begin with: so many, or this part of all.
constexpr std::size_t FirstCentres = 200;
constexpr double FirstPart = 0.02;
/// A round adds at most this part of the centres: less makes fewer centres in more rounds.
constexpr double Growth = 0.3;
/// The fit's own tolerance, as a part of what is allowed to the reduced function.
constexpr double FitShare = 0.1;
/// Rounds that the progress bar is made for.
constexpr double UsualRounds = 12;

class Reduction
{
public:
  Reduction(const std::vector<Point3>& points, const std::vector<double>& values,
    const FunctionOptions& options, Monitor& monitor)
    : Points(points),
      Values(values),
      Options(options),
      Taken(points.size(), 0)
  {
    SubMonitor ordering(monitor, 0, 0.02);
    const MaximinOrder order(points, ordering);
    this->Spacing = order.Distances();
    const std::size_t first = std::min(points.size(),
      std::max(
        FirstCentres, static_cast<std::size_t>(FirstPart * static_cast<double>(points.size()))));
    for (std::size_t rank = 0; rank < first; ++rank)
    {
      this->Take(order.Order()[rank]);
    }
    // The farthest are all outside, it may be; without an inside there is no function.
    const auto [least, largest] = std::minmax_element(values.begin(), values.end());
    this->Take(static_cast<int>(least - values.begin()));
    this->Take(static_cast<int>(largest - values.begin()));
  }

  ImplicitFunction Run(Monitor& monitor)
  {
    for (double round = 0;; ++round)
    {
      const double from = 0.02 + 0.98 * (1 - std::exp(-round / UsualRounds));
      const double to = 0.02 + 0.98 * (1 - std::exp(-(round + 1) / UsualRounds));
      SubMonitor fitting(monitor, from, 0.5 * (from + to));
      ImplicitFunction function = this->Fit(fitting);
      SubMonitor looking(monitor, 0.5 * (from + to), to);
      const double largest = this->Look(function, looking);
      if (largest <= this->Options.CentreReduction || !this->Grow())
      {
        function.Residual = largest;
        this->Tell(function);
        return function;
      }
    }
  }

private:
  void Take(int i)
  {
    if (!this->Taken[i])
    {
      this->Taken[i] = 1;
      this->Chosen.push_back(i);
    }
  }

  ImplicitFunction Fit(Monitor& monitor) const
  {
    FunctionOptions options = this->Options;
    options.CentreReduction = 0;
    const double enough = FitShare * this->Options.CentreReduction;
    options.Tolerance = options.Tolerance > 0 ? std::min(options.Tolerance, enough) : enough;
    std::vector<Point3> points;
    std::vector<double> values;
    for (const int i : this->Chosen)
    {
      points.push_back(this->Points[i]);
      values.push_back(this->Values[i]);
    }
    return FitImplicitFunction(points, values, options, monitor);
  }

  double Look(const ImplicitFunction& function, Monitor& monitor)
  {
    const FunctionEvaluator evaluator(function, this->Options.Threads);
    this->Misfit = evaluator.Values(this->Points, monitor);
    double largest = 0;
    for (std::size_t i = 0; i < this->Misfit.size(); ++i)
    {
      this->Misfit[i] = std::abs(this->Misfit[i] - this->Values[i]);
      largest = std::max(largest, this->Misfit[i]);
    }
    return largest;
  }

  /// Takes the most missed constraint of every cube as wide as the centres' spacing: neighbours of
  /// a new centre need not come with it. @returns false where none is left to take.
  bool Grow()
  {
    const double width = this->Spacing[std::min(this->Chosen.size(), this->Spacing.size()) - 1];
    std::map<std::array<long long, 3>, int> worst;
    for (std::size_t i = 0; i < this->Misfit.size(); ++i)
    {
      if (this->Taken[i] || this->Misfit[i] <= this->Options.CentreReduction)
      {
        continue;
      }
      std::array<long long, 3> cube{};
      for (int a = 0; a < 3; ++a)
      {
        cube[a] = std::llround((this->Points[i][a] - this->Points.front()[a]) / width);
      }
      const int at = static_cast<int>(i);
      const auto [place, isNew] = worst.insert({ cube, at });
      if (!isNew && this->Misfit[i] > this->Misfit[place->second])
      {
        place->second = at;
      }
    }
    std::vector<int> candidates;
    for (const auto& [cube, i] : worst)
    {
      candidates.push_back(i);
    }
    std::sort(candidates.begin(), candidates.end(),
      [&](int i, int j)
      { return std::make_pair(-this->Misfit[i], i) < std::make_pair(-this->Misfit[j], j); });
    const std::size_t most = std::max<std::size_t>(
      1, static_cast<std::size_t>(Growth * static_cast<double>(this->Chosen.size())));
    candidates.resize(std::min(candidates.size(), most));
    for (const int i : candidates)
    {
      this->Take(i);
    }
    return !candidates.empty();
  }

  void Tell(ImplicitFunction& function) const
  {
    char text[160];
    std::snprintf(text, sizeof text,
      "%zu of %zu constraints are centres; the largest misfit of all constraints is %.3g%s.",
      function.Centres.size(), this->Points.size(), function.Residual,
      function.Residual <= this->Options.CentreReduction ? "" : ", more than was asked for");
    function.Report.emplace_back(text);
  }

  const std::vector<Point3>& Points;
  const std::vector<double>& Values;
  FunctionOptions Options;
  std::vector<char> Taken;
  std::vector<int> Chosen;
  std::vector<double> Spacing; ///< of so many points that are spread best
  std::vector<double> Misfit;
};
}

ImplicitFunction FitWithFewCentres(const std::vector<Point3>& points,
  const std::vector<double>& values, const FunctionOptions& options, Monitor& monitor)
{
  return Reduction(points, values, options, monitor).Run(monitor);
}
}
