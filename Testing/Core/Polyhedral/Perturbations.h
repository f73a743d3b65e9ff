// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Perturbations.h
 * @brief What other programs do to contours that are right: decimals cut, levels jittered, outlines
 * stored twice, points dropped, order reversed. The surface must hardly change, and its report must
 * say what was repaired.
 */
#ifndef recon_Testing_Perturbations_h
#define recon_Testing_Perturbations_h

#include "NodeDefaults.h"
#include "PolyhedralSweep.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace recon::testing
{
/// Perturbed contours, with what is allowed to follow from it.
struct Perturbed
{
  LoopSoup Soup;
  std::string What;
  double Rounding = 0;     ///< farthest that a point was moved in its plane, in the set's units
  bool MustReport = false; ///< something is wrong with these contours, and must be named
  bool SameVolume = false; ///< up to other choices among points on common circles
};

class Perturber
{
public:
  explicit Perturber(unsigned seed) : Random(seed) {}

  Perturbed Apply(const LoopSoup& soup)
  {
    switch (this->Random() % 5)
    {
      case 0:
        return this->CutDecimals(soup);
      case 1:
        return this->JitterLevels(soup);
      case 2:
        return this->DoubleOutlines(soup);
      case 3:
        return this->DropPoints(soup);
      default:
        return ReverseOrder(soup);
    }
  }

private:
  static double Rounded(double x, double unit) { return std::round(x / unit) * unit; }

  Perturbed CutDecimals(const LoopSoup& soup)
  {
    const int decimals = static_cast<int>(this->Random() % 5);
    Perturbed result{ soup, std::to_string(decimals) + " decimals" };
    const double unit = std::pow(10.0, -decimals);
    for (Point3& p : result.Soup.Points)
    {
      p = { Rounded(p[0], unit), Rounded(p[1], unit), p[2] };
    }
    result.Rounding = 0.5 * unit;
    return result;
  }

  /// Every contour by itself, as where planes were rounded differently.
  Perturbed JitterLevels(const LoopSoup& soup)
  {
    Perturbed result{ soup, "levels jittered by 0.05" };
    std::uniform_real_distribution<double> jitter(-0.025, 0.025);
    std::set<double> slices;
    for (const LoopSoup::Chain& chain : soup.Chains)
    {
      // A slice of one contour is only moved; one of several falls apart.
      const bool another = !slices.insert(soup.Points[chain.Points[0]][2]).second;
      result.MustReport = result.MustReport || another;
      const double d = jitter(this->Random);
      for (int p : chain.Points)
      {
        result.Soup.Points[p][2] = soup.Points[p][2] + d;
      }
    }
    return result;
  }

  /// A third of the outlines once more with two decimals.
  Perturbed DoubleOutlines(const LoopSoup& soup)
  {
    Perturbed result{ soup, "outlines doubled" };
    for (std::size_t c = 0; c < soup.Chains.size(); ++c)
    {
      if (this->Random() % 3 != 0)
      {
        continue;
      }
      LoopSoup::Chain twin = soup.Chains[c];
      twin.Source = static_cast<int>(result.Soup.Chains.size());
      for (int& p : twin.Points)
      {
        const Point3& q = soup.Points[p];
        p = static_cast<int>(result.Soup.Points.size());
        result.Soup.Points.push_back({ Rounded(q[0], 0.01), Rounded(q[1], 0.01), q[2] });
      }
      result.Soup.Chains.push_back(std::move(twin));
      result.MustReport = true;
    }
    result.Rounding = 0.005;
    return result;
  }

  /// Every fiftieth point, from contours that have enough.
  Perturbed DropPoints(const LoopSoup& soup)
  {
    Perturbed result{ soup, "points dropped" };
    for (LoopSoup::Chain& chain : result.Soup.Chains)
    {
      if (chain.Points.size() >= 40)
      {
        chain.Points.erase(std::remove_if(chain.Points.begin() + 1, chain.Points.end() - 1,
                             [&](int) { return this->Random() % 50 == 0; }),
          chain.Points.end() - 1);
      }
    }
    return result;
  }

  static Perturbed ReverseOrder(const LoopSoup& soup)
  {
    Perturbed result{ soup, "order reversed" };
    std::reverse(result.Soup.Chains.begin(), result.Soup.Chains.end());
    for (LoopSoup::Chain& chain : result.Soup.Chains)
    {
      std::reverse(chain.Points.begin(), chain.Points.end());
    }
    result.SameVolume = true;
    return result;
  }

  std::mt19937 Random;
};

/// The options that users meet.
inline PolyhedralOptions OptionsOfUsers()
{
  PolyhedralOptions options = NodeOptions();
  options.AlignLevels = LevelAlignmentMode::Automatic;
  return options;
}

/// Upright regions of structure sets with enough points to mean something, and few enough for a
/// second.
inline std::vector<NamedSoup> SetsToPerturb()
{
  std::vector<NamedSoup> sets;
  for (const char* folder : { "rtstruct", "rtstruct/phantoms", "ibsi" })
  {
    ForSoups(SharedPath(folder), ".dcm",
      [&](const std::string& name, const LoopSoup& soup)
      {
        const bool upright = std::all_of(soup.Chains.begin(), soup.Chains.end(),
          [&](const LoopSoup::Chain& chain)
          {
            return std::all_of(chain.Points.begin(), chain.Points.end(),
              [&](int p) { return soup.Points[p][2] == soup.Points[chain.Points[0]][2]; });
          });
        if (upright && soup.Chains.size() >= 4 && soup.Points.size() >= 400 &&
          soup.Points.size() <= 9000)
        {
          sets.emplace_back(name, soup);
        }
      });
  }
  return sets;
}

/// Perimeter times thickness, about the area of the walls.
inline double WallArea(const ContourSet& contours)
{
  double length = 0;
  for (const Contour& contour : contours.Contours)
  {
    length += LengthAlong(contours.Points, contour.Points);
  }
  return length * (contours.Levels.back().Offset - contours.Levels.front().Offset) /
    static_cast<double>(contours.Levels.size() - 1);
}

/// What perturbations of one kind did at most.
struct PerturbationTally
{
  int Count = 0;
  double Change = 0; ///< of the volume, a share
  double Time = 0;   ///< of the processor, beside that of the contours as they were
};

/// Contours as they were with their surface, which many perturbations are compared with.
struct Unperturbed
{
  ContourSet Contours;
  double Volume = 0;
  std::size_t Triangles = 0;
  double Seconds = 0; ///< of the processor; 0: makes no solid
};

inline double ProcessorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

inline Unperturbed MakeUnperturbed(const LoopSoup& soup)
{
  Unperturbed was;
  const double start = ProcessorSeconds();
  if (MakesASolid(soup, was.Contours))
  {
    const PolyhedralSurface surface = BuildSurface(was.Contours, OptionsOfUsers());
    was.Seconds = ProcessorSeconds() - start;
    was.Volume = VolumeOf(surface.Mesh);
    was.Triangles = surface.Mesh.Triangles.size();
  }
  return was;
}

inline void ExpectHardlyChanged(const NamedSoup& set, const Unperturbed& was, unsigned seed,
  std::map<std::string, PerturbationTally>& tallies)
{
  const Perturbed perturbed = Perturber(seed).Apply(set.second);
  SCOPED_TRACE(set.first + ", " + perturbed.What + ", seed " + std::to_string(seed));
  ContourSet after;
  const double start = ProcessorSeconds();
  ASSERT_TRUE(MakesASolid(perturbed.Soup, after)) << "nothing is left";
  const PolyhedralSurface is = BuildSurface(after, OptionsOfUsers());
  const double seconds = ProcessorSeconds() - start;
  ExpectClosed(is.Mesh);
  ExpectManifold(is.Mesh);
  ExpectOriented(is.Mesh);
  ExpectNoSelfIntersections(is.Mesh);
  const double change = std::abs(VolumeOf(is.Mesh) - was.Volume) / was.Volume;
  EXPECT_LE(change,
    perturbed.SameVolume ? 1e-4 : 0.005 + perturbed.Rounding * WallArea(was.Contours) / was.Volume);
  EXPECT_LE(is.Mesh.Triangles.size(), 3 * was.Triangles) << "points without end";
  // A set takes a fraction of a second, which another test beside this one may double.
  EXPECT_LE(seconds, 3 * was.Seconds + 0.5);
  if (perturbed.MustReport || after.Contours.size() < perturbed.Soup.Chains.size())
  {
    EXPECT_GT(after.Report.size(), 0u) << "nothing was said";
  }
  PerturbationTally& tally = tallies[perturbed.What];
  ++tally.Count;
  tally.Change = std::max(tally.Change, change);
  tally.Time = std::max(tally.Time, seconds / was.Seconds);
}

/// `count` perturbations of sets in turn, from CONTOUR_PERTURBATION_SEED on.
inline void PerturbSets(int count)
{
  const char* const given = std::getenv("CONTOUR_PERTURBATION_SEED");
  const unsigned first = given ? static_cast<unsigned>(std::atoi(given)) : 1;
  const std::vector<NamedSoup> sets = SetsToPerturb();
  ASSERT_GT(sets.size(), 10u);
  std::map<std::size_t, Unperturbed> unperturbed;
  std::map<std::string, PerturbationTally> tallies;
  for (int i = 0; i < count; ++i)
  {
    const unsigned seed = first + static_cast<unsigned>(i);
    const std::size_t number = seed % sets.size();
    const NamedSoup& set = sets[number];
    if (unperturbed.count(number) == 0)
    {
      unperturbed[number] = MakeUnperturbed(set.second);
    }
    if (unperturbed[number].Seconds > 0)
    {
      ExpectHardlyChanged(set, unperturbed[number], seed, tallies);
    }
  }
  for (const auto& [what, tally] : tallies)
  {
    std::printf("[ NOTE     ] %s: %d times, volume by at most %.3f%%, time at most %.2f-fold\n",
      what.c_str(), tally.Count, 100 * tally.Change, tally.Time);
  }
}
}

#endif
