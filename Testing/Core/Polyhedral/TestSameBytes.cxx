// SPDX-License-Identifier: GPL-3.0-or-later
// The same contours give the same surface to the last bit: with any number of threads, again, and with slices in any order.
#include "NestedStacks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <vector>

using namespace recon;
using namespace recon::testing;

namespace
{
constexpr unsigned Stacks = 12;
const std::array<int, 3> ThreadCounts{ 1, 2, 8 };

/// A triangle by its corners' coordinates, which begins with the least of them.
using Corners = std::array<Point3, 3>;

/// All of a mesh, in an order that numbers have no part in.
std::vector<Corners> WithoutNumbers(const TriangleMesh& mesh)
{
  std::vector<Corners> all;
  for (const auto& t : mesh.Triangles)
  {
    Corners corners{ mesh.Points[t[0]], mesh.Points[t[1]], mesh.Points[t[2]] };
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.push_back(corners);
  }
  std::sort(all.begin(), all.end());
  return all;
}

ContourSet ContoursOf(const LoopSoup& soup, const ContourSetOptions& cleaning)
{
  Monitor monitor;
  return BuildContourSet(soup, cleaning, monitor);
}

void ExpectSame(const TriangleMesh& mesh, const TriangleMesh& first)
{
  EXPECT_EQ(mesh.Points, first.Points);
  EXPECT_EQ(mesh.Triangles, first.Triangles);
}

/// The contours' points, each from the least of them on.
std::vector<std::vector<Point3>> WithoutNumbers(const ContourSet& contours)
{
  std::vector<std::vector<Point3>> all;
  for (const Contour& contour : contours.Contours)
  {
    std::vector<Point3> loop;
    for (const int p : contour.Points)
    {
      loop.push_back(contours.Points[p]);
    }
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    all.push_back(std::move(loop));
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// A file of those slices, in an order of their own for each number but 0.
LoopSoup SoupOf(const RingStack& levels, unsigned order)
{
  std::vector<std::size_t> numbers(levels.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  if (order > 0)
  {
    std::mt19937 random(order);
    std::shuffle(numbers.begin(), numbers.end(), random);
  }
  SoupMaker maker;
  for (const std::size_t l : numbers)
  {
    for (const Ring& ring : levels[l])
    {
      maker.Loop(ring, static_cast<double>(l));
    }
  }
  return maker.Soup;
}

/// The chains of a soup as another program might write them.
LoopSoup Shuffled(const LoopSoup& soup, unsigned seed)
{
  LoopSoup shuffled = soup;
  std::mt19937 random(seed);
  std::shuffle(shuffled.Chains.begin(), shuffled.Chains.end(), random);
  int number = 0;
  for (LoopSoup::Chain& chain : shuffled.Chains)
  {
    chain.Source = number++;
  }
  return shuffled;
}
}

TEST(SameBytes, PolyhedralSurfaceWithAnyThreads)
{
  Monitor monitor;
  for (unsigned seed = 1; seed <= Stacks; ++seed)
  {
    SCOPED_TRACE(seed);
    const NestedStack stack(seed);
    if (stack.Soup.Chains.empty())
    {
      continue;
    }
    const ContourSet contours = ContoursOf(stack.Soup, stack.Cleaning);
    if (contours.Levels.size() < 2)
    {
      continue;
    }
    PolyhedralOptions options = stack.Options;
    options.PinchGap = 1e-3;
    options.Threads = 1;
    const PolyhedralSurface first = BuildPolyhedralSurface(contours, options, monitor);
    for (const int threads : ThreadCounts)
    {
      options.Threads = threads;
      const PolyhedralSurface surface = BuildPolyhedralSurface(contours, options, monitor);
      ExpectSame(surface.Mesh, first.Mesh);
      EXPECT_EQ(surface.Report, first.Report);
      EXPECT_EQ(surface.Piece, first.Piece);
      EXPECT_EQ(surface.MappingGroup, first.MappingGroup);
    }
  }
}

TEST(SameBytes, PolyhedralSurfaceWithSlicesInAnyOrder)
{
  Monitor monitor;
  PolyhedralOptions options;
  options.PinchGap = 1e-3;
  for (unsigned seed = 1; seed <= Stacks; ++seed)
  {
    SCOPED_TRACE(seed);
    const RingStack levels = RandomStack(seed);
    const ContourSet contours = ContoursOf(SoupOf(levels, 0), {});
    if (contours.Levels.size() < 2)
    {
      continue;
    }
    const std::vector<Corners> first =
      WithoutNumbers(BuildPolyhedralSurface(contours, options, monitor).Mesh);
    for (unsigned order = 1; order <= 3; ++order)
    {
      const ContourSet others = ContoursOf(SoupOf(levels, order), {});
      EXPECT_TRUE(WithoutNumbers(BuildPolyhedralSurface(others, options, monitor).Mesh) == first);
    }
  }
}

/// What does not cross; where it does, the rule of holes may see another one first.
TEST(SameBytes, ContoursInAnyOrder)
{
  for (unsigned seed = 1; seed <= Stacks; ++seed)
  {
    SCOPED_TRACE(seed);
    const LoopSoup soup = SoupOf(RandomStack(seed), 0);
    const std::vector<std::vector<Point3>> first = WithoutNumbers(ContoursOf(soup, {}));
    for (unsigned order = 1; order <= 3; ++order)
    {
      EXPECT_EQ(WithoutNumbers(ContoursOf(Shuffled(soup, order), {})), first);
    }
  }
}
