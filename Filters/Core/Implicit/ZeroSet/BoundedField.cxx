// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/ZeroSet/BoundedField.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace recon
{
namespace
{
/// Newton's steps; a smooth function met from within half a cell needs three or four.
constexpr int MaximumSteps = 8;
}

BoundedField::BoundedField(
  const ImplicitFunction& function, const Bounds& box, bool closed, int threads, Monitor& monitor)
  : Function(std::make_shared<FunctionEvaluator>(function, threads)),
    Limits(box),
    ClosedAtBox(closed),
    Stop(monitor)
{
}

BoundedField BoundedField::Open() const
{
  BoundedField open = *this;
  open.ClosedAtBox = false;
  return open;
}

double BoundedField::BoxValue(const Point3& x, int& axis, double& sign) const
{
  double least = std::numeric_limits<double>::infinity();
  for (int a = 0; a < 3; ++a)
  {
    const double low = x[a] - this->Limits[2 * a];
    const double high = this->Limits[2 * a + 1] - x[a];
    if (std::min(low, high) < least)
    {
      least = std::min(low, high);
      axis = a;
      sign = low < high ? 1 : -1;
    }
  }
  return least;
}

std::vector<double> BoundedField::Values(const std::vector<Point3>& points) const
{
  std::vector<double> values = this->Function->Values(points, this->Stop);
  if (this->ClosedAtBox)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      int axis = 0;
      double sign = 1;
      values[i] = std::min(values[i], this->BoxValue(points[i], axis, sign));
    }
  }
  return values;
}

void BoundedField::Evaluate(const std::vector<Point3>& points, std::vector<double>& values,
  std::vector<Vector3>& gradients) const
{
  this->Function->ValuesAndGradients(points, values, gradients, this->Stop);
  if (!this->ClosedAtBox)
  {
    return;
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    int axis = 0;
    double sign = 1;
    const double box = this->BoxValue(points[i], axis, sign);
    // Whichever surface is nearer in space, not in value, says which way is out: f has its own
    // scale.
    if (box * Norm(gradients[i]) < values[i])
    {
      gradients[i] = { 0, 0, 0 };
      gradients[i][axis] = sign;
      values[i] = box;
    }
  }
}

void BoundedField::Project(std::vector<Point3>& points, std::vector<Vector3>& normals,
  std::vector<char>& done, double limit, double tolerance) const
{
  std::vector<Point3> moved = points;
  done.assign(points.size(), 0);
  normals.assign(points.size(), Vector3{ 0, 0, 0 });
  std::vector<std::size_t> active(points.size());
  for (std::size_t i = 0; i < active.size(); ++i)
  {
    active[i] = i;
  }
  std::vector<Point3> at;
  std::vector<double> values;
  std::vector<Vector3> gradients;
  for (int step = 0; step < MaximumSteps && !active.empty(); ++step)
  {
    at.clear();
    for (const std::size_t i : active)
    {
      at.push_back(moved[i]);
    }
    this->Evaluate(at, values, gradients);
    std::vector<std::size_t> still;
    for (std::size_t k = 0; k < active.size(); ++k)
    {
      const std::size_t i = active[k];
      const double steep = Norm(gradients[k]);
      if (!(steep > 0))
      {
        continue;
      }
      normals[i] = (-1 / steep) * gradients[k];
      const double distance = values[k] / steep;
      if (std::abs(distance) <= tolerance)
      {
        done[i] = 1;
        continue;
      }
      moved[i] = moved[i] + distance * normals[i];
      if (Norm(moved[i] - points[i]) <= limit)
      {
        still.push_back(i);
      }
    }
    active = std::move(still);
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (done[i])
    {
      points[i] = moved[i];
    }
  }
}

Bounds BoundsOf(const std::vector<Point3>& points)
{
  const double infinity = std::numeric_limits<double>::infinity();
  Bounds box{ infinity, -infinity, infinity, -infinity, infinity, -infinity };
  for (const Point3& p : points)
  {
    for (int a = 0; a < 3; ++a)
    {
      if (!std::isfinite(p[a]))
      {
        throw Error("A point has a coordinate that is not a finite number: leave it out.");
      }
      box[2 * a] = std::min(box[2 * a], p[a]);
      box[2 * a + 1] = std::max(box[2 * a + 1], p[a]);
    }
  }
  if (points.empty())
  {
    throw Error(
      "There is no point to start from: give the contours, or a model with its constraints.");
  }
  return box;
}

double DiagonalOf(const Bounds& box)
{
  return Norm({ box[1] - box[0], box[3] - box[2], box[5] - box[4] });
}

void CheckBounds(const Bounds& box)
{
  for (int a = 0; a < 3; ++a)
  {
    if (!(box[2 * a] < box[2 * a + 1]) || !std::isfinite(box[2 * a + 1] - box[2 * a]))
    {
      throw Error("The bounds are empty or not finite along axis " + std::to_string(a) +
        ": give a smallest and a larger largest coordinate.");
    }
  }
}
}
