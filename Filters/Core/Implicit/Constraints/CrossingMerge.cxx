// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Constraints/CrossingMerge.h"

#include "Base/PointGrid.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace recon
{
namespace
{
/// Merged margins that cancel to less than this part of d have no common side.
constexpr double LeastMergedMargin = 0.2;

/// Groups of points of crossing planes that fit in one small box (thesis 9.1).
class MergeGroups
{
public:
  MergeGroups(
    const ContourSet& contours, const std::vector<VertexMargins>& margins, const Vector3& box)
    : Boxes(margins.size()),
      Parent(margins.size()),
      Limit(box)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
    for (std::size_t i = 0; i < margins.size(); ++i)
    {
      this->Boxes[i].Add(margins[i].Vertex);
    }
    for (const auto& pair : CrossingPairs(contours, margins, box))
    {
      this->Join(this->Find(pair.I), this->Find(pair.J));
    }
  }

  int Find(int i)
  {
    while (this->Parent[i] != i)
    {
      i = this->Parent[i] = this->Parent[this->Parent[i]];
    }
    return i;
  }

private:
  struct Pair
  {
    double Distance2;
    int I;
    int J;
    bool operator<(const Pair& o) const
    {
      return std::tie(this->Distance2, this->I, this->J) < std::tie(o.Distance2, o.I, o.J);
    }
  };

  static std::vector<Pair> CrossingPairs(
    const ContourSet& contours, const std::vector<VertexMargins>& margins, const Vector3& box)
  {
    std::vector<Point3> vertices;
    for (const VertexMargins& m : margins)
    {
      vertices.push_back(m.Vertex);
    }
    const double reach = Norm(box);
    const PointGrid grid(vertices, reach);
    std::vector<Pair> pairs;
    for (int i = 0; i < static_cast<int>(margins.size()); ++i)
    {
      grid.ForNear(vertices[i], reach,
        [&](int j, double r2)
        {
          const Vector3& a = contours.Levels[margins[i].Level].Frame.Normal;
          const Vector3& b = contours.Levels[margins[j].Level].Frame.Normal;
          if (j > i && Norm(Cross(a, b)) > ParallelSine)
          {
            pairs.push_back({ r2, i, j });
          }
        });
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  void Join(int i, int j)
  {
    if (i == j)
    {
      return;
    }
    Box3 joint = this->Boxes[i];
    joint.Add(this->Boxes[j]);
    for (int a = 0; a < 3; ++a)
    {
      if (joint.High[a] - joint.Low[a] > this->Limit[a])
      {
        return;
      }
    }
    this->Parent[std::max(i, j)] = std::min(i, j);
    this->Boxes[std::min(i, j)] = joint;
  }

  std::vector<Box3> Boxes;
  std::vector<int> Parent;
  Vector3 Limit;
};

/// One vertex in the place of a group: centroids of the points and of their margins.
VertexMargins Centroid(const std::vector<VertexMargins>& margins, const std::vector<int>& group)
{
  VertexMargins mean;
  mean.Level = margins[group.front()].Level;
  const auto centroid = [&](Point3 VertexMargins::*place, double VertexMargins::*distance)
  {
    Point3 sum{ 0, 0, 0 };
    int count = 0;
    for (const int i : group)
    {
      if (!distance || margins[i].*distance > 0)
      {
        // An offset, not a place: a member without this margin must not pull the others' mean.
        sum = sum + (distance ? margins[i].*place - margins[i].Vertex : margins[i].*place);
        ++count;
      }
    }
    return count > 0 ? (1.0 / count) * sum : Point3{ 0, 0, 0 };
  };
  mean.Vertex = centroid(&VertexMargins::Vertex, nullptr);
  const Vector3 inner = centroid(&VertexMargins::Inner, &VertexMargins::InnerDistance);
  const Vector3 outer = centroid(&VertexMargins::Outer, &VertexMargins::OuterDistance);
  mean.Inner = mean.Vertex + inner;
  mean.Outer = mean.Vertex + outer;
  mean.InnerDistance = mean.InnerValue = Norm(inner);
  mean.OuterDistance = mean.OuterValue = Norm(outer);
  return mean;
}
}

std::vector<VertexMargins> MergeAtCrossings(const ContourSet& contours,
  const std::vector<VertexMargins>& margins, double part, double distance,
  std::vector<std::string>& report)
{
  const Box3 box = contours.Bounds();
  MergeGroups groups(contours, margins, part * (box.High - box.Low));
  std::vector<std::vector<int>> members(margins.size());
  for (int i = 0; i < static_cast<int>(margins.size()); ++i)
  {
    members[groups.Find(i)].push_back(i);
  }
  std::vector<VertexMargins> merged;
  std::size_t gone = 0;
  std::size_t places = 0;
  for (const auto& group : members)
  {
    if (group.size() == 1)
    {
      merged.push_back(margins[group.front()]);
    }
    if (group.size() < 2)
    {
      continue;
    }
    gone += group.size();
    ++places;
    VertexMargins mean = Centroid(margins, group);
    // Contours that disagree about the side leave a point without one.
    mean.InnerDistance = mean.InnerDistance < LeastMergedMargin * distance ? 0 : mean.InnerDistance;
    mean.OuterDistance = mean.OuterDistance < LeastMergedMargin * distance ? 0 : mean.OuterDistance;
    merged.push_back(mean);
  }
  if (places > 0)
  {
    report.push_back(std::to_string(gone) + " points near the crossings of planes became " +
      std::to_string(places) + " centroids.");
  }
  return merged;
}
}
