// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/BalancedShares.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace
{
std::size_t Heaviest(
  const std::vector<std::size_t>& weights, const std::vector<int>& shareOf, int shares)
{
  std::vector<std::size_t> loads(static_cast<std::size_t>(shares), 0);
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    loads[static_cast<std::size_t>(shareOf[i])] += weights[i];
  }
  return *std::max_element(loads.begin(), loads.end());
}

/// Over all ways there are.
std::size_t BestHeaviest(const std::vector<std::size_t>& weights, int shares)
{
  std::size_t best = std::numeric_limits<std::size_t>::max();
  std::vector<int> shareOf(weights.size(), 0);
  for (;;)
  {
    best = std::min(best, Heaviest(weights, shareOf, shares));
    std::size_t i = 0;
    while (i < shareOf.size() && ++shareOf[i] == shares)
    {
      shareOf[i++] = 0;
    }
    if (i == shareOf.size())
    {
      return best;
    }
  }
}
}

TEST(BalancedShares, AreWithinGrahamsBoundOfTheBest)
{
  std::mt19937 random(3);
  for (int trial = 0; trial < 60; ++trial)
  {
    const int shares = 2 + trial % 3;
    std::vector<std::size_t> weights(1 + random() % 7);
    for (std::size_t& weight : weights)
    {
      weight = 1 + random() % 30;
    }
    const std::vector<int> shareOf = recon::BalancedShares(weights, shares);
    ASSERT_EQ(shareOf.size(), weights.size());
    const auto bound = static_cast<double>(BestHeaviest(weights, shares)) *
      (4.0 / 3.0 - 1.0 / (3.0 * static_cast<double>(shares)));
    EXPECT_LE(static_cast<double>(Heaviest(weights, shareOf, shares)), bound + 1e-9) << trial;
  }
}

TEST(BalancedShares, OneShareHasAll)
{
  EXPECT_EQ(recon::BalancedShares({ 5, 0, 7 }, 1), (std::vector<int>{ 0, 0, 0 }));
  EXPECT_TRUE(recon::BalancedShares({}, 4).empty());
}

TEST(BalancedShares, NoShareHasTwoWhereAnotherHasNone)
{
  const std::vector<int> shareOf = recon::BalancedShares({ 4, 4, 4, 4 }, 6);
  EXPECT_EQ(std::set<int>(shareOf.begin(), shareOf.end()).size(), 4U);
}

TEST(BalancedShares, TiesGoByTheOrder)
{
  EXPECT_EQ(recon::BalancedShares({ 1, 9, 9, 1 }, 2), (std::vector<int>{ 0, 0, 1, 1 }));
}
