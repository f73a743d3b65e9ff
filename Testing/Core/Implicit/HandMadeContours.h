// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file HandMadeContours.h
 * @brief Contour sets of known shapes for the tests, made without the builder that other tests are
 * about.
 */
#ifndef recon_HandMadeContours_h
#define recon_HandMadeContours_h

#include "Contours/ContourSet.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace handmade
{
using namespace recon; // operators of the value types: they are std::arrays, so not found by their
                       // arguments

inline recon::PlanarFrame FrameOf(const Vector3& normal)
{
  recon::PlanarFrame frame;
  frame.Normal = (1 / Norm(normal)) * normal;
  const int least = std::abs(frame.Normal[0]) <= std::abs(frame.Normal[1])
    ? (std::abs(frame.Normal[0]) <= std::abs(frame.Normal[2]) ? 0 : 2)
    : (std::abs(frame.Normal[1]) <= std::abs(frame.Normal[2]) ? 1 : 2);
  Vector3 axis{ 0, 0, 0 };
  axis[least] = 1;
  const Vector3 u = Cross(axis, frame.Normal);
  frame.U = (1 / Norm(u)) * u;
  frame.V = Cross(frame.Normal, frame.U);
  return frame;
}

/// Collects contours level by level; Finish() turns and nests them.
class Maker
{
public:
  int AddLevel(const Vector3& normal, double offset)
  {
    recon::Level level;
    level.Frame = FrameOf(normal);
    level.Offset = offset;
    this->Set.Levels.push_back(level);
    return static_cast<int>(this->Set.Levels.size()) - 1;
  }

  void AddContour(int level, const std::vector<Point3>& loop)
  {
    recon::Contour contour;
    contour.Level = level;
    contour.Source = static_cast<int>(this->Set.Contours.size());
    for (const Point3& p : loop)
    {
      const Point2 planar = this->Set.Levels[level].Frame.ToPlane(p);
      if (!contour.Points.empty() && this->Set.Planar.back() == planar)
      {
        continue;
      }
      contour.Points.push_back(static_cast<int>(this->Set.Points.size()));
      this->Set.Points.push_back(p);
      this->Set.Planar.push_back(planar);
    }
    while (contour.Points.size() > 1 &&
      this->Set.Planar[contour.Points.back()] == this->Set.Planar[contour.Points.front()])
    {
      contour.Points.pop_back();
    }
    if (contour.Points.size() >= 3)
    {
      this->Set.Levels[level].Contours.push_back(static_cast<int>(this->Set.Contours.size()));
      this->Set.Contours.push_back(contour);
    }
  }

  /// A polygon of n points in the level's plane, at in-plane coordinates radius * (cos, sin) +
  /// centre.
  void AddCircle(int level, const Point2& centre, double radius, int n, double phase = 0)
  {
    std::vector<Point3> loop;
    for (int i = 0; i < n; ++i)
    {
      const double angle = phase + 2 * 3.14159265358979323846 * i / n;
      loop.push_back(this->Set.Levels[level].Frame.ToSpace(
        { centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle) },
        this->Set.Levels[level].Offset));
    }
    this->AddContour(level, loop);
  }

  recon::ContourSet Finish()
  {
    for (recon::Level& level : this->Set.Levels)
    {
      for (const int c : level.Contours)
      {
        this->Nest(level, c);
      }
      for (const int c : level.Contours)
      {
        recon::Contour& contour = this->Set.Contours[c];
        contour.SignedArea = this->AreaOf(contour);
        if ((contour.SignedArea > 0) != (contour.Depth % 2 == 0))
        {
          std::reverse(contour.Points.begin(), contour.Points.end());
          contour.SignedArea = -contour.SignedArea;
        }
      }
    }
    return this->Set;
  }

private:
  double AreaOf(const recon::Contour& contour) const
  {
    double twice = 0;
    const Point2& o = this->Set.Planar[contour.Points.front()];
    for (std::size_t i = 0; i < contour.Points.size(); ++i)
    {
      const Point2& a = this->Set.Planar[contour.Points[i]];
      const Point2& b = this->Set.Planar[contour.Points[(i + 1) % contour.Points.size()]];
      twice += (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
    }
    return 0.5 * twice;
  }

  bool Contains(const recon::Contour& contour, const Point2& p) const
  {
    bool inside = false;
    for (std::size_t i = 0; i < contour.Points.size(); ++i)
    {
      const Point2& a = this->Set.Planar[contour.Points[i]];
      const Point2& b = this->Set.Planar[contour.Points[(i + 1) % contour.Points.size()]];
      if ((a[1] > p[1]) != (b[1] > p[1]) &&
        p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]))
      {
        inside = !inside;
      }
    }
    return inside;
  }

  void Nest(const recon::Level& level, int c)
  {
    recon::Contour& contour = this->Set.Contours[c];
    double least = 0;
    for (const int other : level.Contours)
    {
      const recon::Contour& around = this->Set.Contours[other];
      if (other == c || !this->Contains(around, this->Set.Planar[contour.Points.front()]))
      {
        continue;
      }
      ++contour.Depth;
      const double area = std::abs(this->AreaOf(around));
      if (contour.Parent < 0 || area < least)
      {
        contour.Parent = other;
        least = area;
      }
    }
  }

  recon::ContourSet Set;
};
}

#endif
