// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Solver/MaximinOrder.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>

namespace recon
{
namespace
{
constexpr const char* Stage = "preparing the fit";
constexpr int PointsPerLeaf = 12;    ///< of the tree that neighbours are looked up in
constexpr int RanksPerUpdate = 4096; ///< between looks at the progress and for an abort

double Distance2To(const Point3& x, const Point3& low, const Point3& high)
{
  double d2 = 0;
  for (int a = 0; a < 3; ++a)
  {
    const double d = std::max({ low[a] - x[a], 0.0, x[a] - high[a] });
    d2 += d * d;
  }
  return d2;
}

double Distance2Between(const Point3& a, const Point3& b)
{
  const Vector3 d = a - b;
  return Dot(d, d);
}
}

MaximinOrder::MaximinOrder(const std::vector<Point3>& points, Monitor& monitor)
{
  const std::size_t n = points.size();
  monitor.Update(0, Stage);
  this->Build(points);
  monitor.Update(0, Stage);
  this->Distance2.assign(n, std::numeric_limits<double>::max());
  this->RankOf.assign(n, -1);
  this->ByRank.reserve(n);
  this->DistanceByRank.reserve(n);
  this->PointsByRank.reserve(n);
  this->RankStart();
  this->RankRest(monitor);
  this->FindLeastRanks();
  this->Distance2 = {};
}

void MaximinOrder::Build(const std::vector<Point3>& points)
{
  const int n = static_cast<int>(points.size());
  this->Input.resize(n);
  std::iota(this->Input.begin(), this->Input.end(), 0);
  this->InTree = points;
  this->Nodes.push_back({ {}, {}, 0, n, -1, std::numeric_limits<double>::max(), 0 });
  for (std::size_t node = 0; node < this->Nodes.size(); ++node)
  {
    this->Split(static_cast<int>(node));
  }
  for (int i = 0; i < n; ++i)
  {
    this->InTree[i] = points[this->Input[i]];
  }
}

/// InTree still has the order of the input here.
void MaximinOrder::Split(int at)
{
  Node node = this->Nodes[at];
  node.Low = node.High = this->InTree[this->Input[node.Begin]];
  for (int i = node.Begin + 1; i < node.End; ++i)
  {
    const Point3& p = this->InTree[this->Input[i]];
    for (int a = 0; a < 3; ++a)
    {
      node.Low[a] = std::min(node.Low[a], p[a]);
      node.High[a] = std::max(node.High[a], p[a]);
    }
  }
  if (node.End - node.Begin > PointsPerLeaf)
  {
    const Vector3 size = node.High - node.Low;
    const int axis = static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
    const int middle = (node.Begin + node.End) / 2;
    std::nth_element(this->Input.begin() + node.Begin, this->Input.begin() + middle,
      this->Input.begin() + node.End,
      [&](int i, int j)
      {
        // Ties by index, so that every standard library builds the same tree.
        return std::make_pair(this->InTree[i][axis], i) < std::make_pair(this->InTree[j][axis], j);
      });
    node.Left = static_cast<int>(this->Nodes.size());
    Node child = node;
    child.Left = -1;
    child.End = middle;
    this->Nodes.push_back(child);
    child.Begin = middle;
    child.End = node.End;
    this->Nodes.push_back(child);
  }
  this->Nodes[at] = node;
}

/// The point farthest from the line or plane through `from` along the orthonormal `known`.
int MaximinOrder::FarthestFrom(const Point3& from, const std::vector<Vector3>& known) const
{
  int best = 0;
  double largest = -1;
  for (std::size_t i = 0; i < this->InTree.size(); ++i)
  {
    Vector3 d = this->InTree[i] - from;
    for (const Vector3& u : known)
    {
      d = d - Dot(d, u) * u;
    }
    const double d2 = Dot(d, d);
    if (d2 > largest && this->RankOf[i] < 0)
    {
      largest = d2;
      best = static_cast<int>(i);
    }
  }
  return best;
}

void MaximinOrder::RankStart()
{
  Point3 mean{ 0, 0, 0 };
  for (const Point3& p : this->InTree)
  {
    mean = mean + (1.0 / static_cast<double>(this->InTree.size())) * p;
  }
  Point3 from = mean;
  std::vector<Vector3> known;
  for (int k = 0; k < Simplex; ++k)
  {
    const int next = this->FarthestFrom(from, known);
    const Point3 p = this->InTree[next];
    if (k > 0)
    {
      Vector3 d = p - from;
      for (const Vector3& u : known)
      {
        d = d - Dot(d, u) * u;
      }
      known.push_back((1 / Norm(d)) * d);
    }
    else
    {
      from = p;
    }
    this->Rank(next, this->Distance2[next]);
  }
}

void MaximinOrder::RankRest(Monitor& monitor)
{
  const std::size_t n = this->InTree.size();
  while (this->ByRank.size() < n)
  {
    const int next = this->FarthestLeft();
    this->Rank(next, this->Distance2[next]);
    if (this->ByRank.size() % RanksPerUpdate == 0)
    {
      monitor.Update(static_cast<double>(this->ByRank.size()) / static_cast<double>(n), Stage);
    }
  }
}

void MaximinOrder::Rank(int at, double distance2)
{
  this->RankOf[at] = static_cast<int>(this->ByRank.size());
  this->ByRank.push_back(this->Input[at]);
  this->PointsByRank.push_back(this->InTree[at]);
  this->DistanceByRank.push_back(std::sqrt(distance2));
  this->Approach(0, this->InTree[at]);
}

/// A ranked point is at `to`: distances below the node may have shrunk.
void MaximinOrder::Approach(int at, const Point3& to)
{
  Node& node = this->Nodes[at];
  if (Distance2To(to, node.Low, node.High) > node.Farthest2)
  {
    return;
  }
  if (node.Left >= 0)
  {
    this->Approach(node.Left, to);
    this->Approach(node.Left + 1, to);
    node.Farthest2 =
      std::max(this->Nodes[node.Left].Farthest2, this->Nodes[node.Left + 1].Farthest2);
    return;
  }
  node.Farthest2 = -1;
  for (int i = node.Begin; i < node.End; ++i)
  {
    if (this->RankOf[i] < 0)
    {
      this->Distance2[i] = std::min(this->Distance2[i], Distance2Between(this->InTree[i], to));
      node.Farthest2 = std::max(node.Farthest2, this->Distance2[i]);
    }
  }
}

int MaximinOrder::FarthestLeft() const
{
  int at = 0;
  while (this->Nodes[at].Left >= 0)
  {
    const int left = this->Nodes[at].Left;
    at = this->Nodes[left].Farthest2 >= this->Nodes[left + 1].Farthest2 ? left : left + 1;
  }
  const Node& leaf = this->Nodes[at];
  int best = -1;
  for (int i = leaf.Begin; i < leaf.End; ++i)
  {
    if (this->RankOf[i] < 0 && (best < 0 || this->Distance2[i] > this->Distance2[best]))
    {
      best = i;
    }
  }
  return best;
}

void MaximinOrder::FindLeastRanks()
{
  for (std::size_t i = this->Nodes.size(); i-- > 0;)
  {
    Node& node = this->Nodes[i];
    node.LeastRank = node.Left < 0
      ? *std::min_element(this->RankOf.begin() + node.Begin, this->RankOf.begin() + node.End)
      : std::min(this->Nodes[node.Left].LeastRank, this->Nodes[node.Left + 1].LeastRank);
  }
}

void MaximinOrder::Search(int at, Query& query) const
{
  const Node& node = this->Nodes[at];
  if (node.Left < 0)
  {
    for (int i = node.Begin; i < node.End; ++i)
    {
      if (this->RankOf[i] < query.Below)
      {
        query.Offer({ Distance2Between(query.At, this->InTree[i]), this->RankOf[i] });
      }
    }
    return;
  }
  std::array<std::pair<double, int>, 2> children;
  for (int c = 0; c < 2; ++c)
  {
    const Node& child = this->Nodes[node.Left + c];
    children[c] = { Distance2To(query.At, child.Low, child.High), node.Left + c };
  }
  if (children[1] < children[0])
  {
    std::swap(children[0], children[1]);
  }
  for (const auto& [d2, child] : children)
  {
    if (this->Nodes[child].LeastRank < query.Below && d2 <= query.Reach())
    {
      this->Search(child, query);
    }
  }
}

std::vector<int> MaximinOrder::Nearest(const Point3& x, int below, int count) const
{
  Query query{ x, below, static_cast<std::size_t>(count), {} };
  query.Best.reserve(query.Count);
  this->Search(0, query);
  std::vector<int> ranks;
  ranks.reserve(query.Best.size());
  for (const Found& found : query.Best)
  {
    ranks.push_back(found.second);
  }
  std::sort(ranks.begin(), ranks.end());
  return ranks;
}
}
