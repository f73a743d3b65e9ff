// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Constraints/RefinedMargins.h"

#include "Base/PointGrid.h"
#include "Implicit/Constraints/ContourTips.h"
#include "Implicit/FastMultipole/FunctionEvaluator.h"

#include <algorithm>

namespace recon
{
namespace
{
/// A vertex whose in-plane margins had to shrink below this part of d is not turned, nor one whose
/// margins reach farther than the other part of it.
constexpr double LeastRoom = 0.6;
constexpr double MostReach = 1.01;
/// Cosine of the angle between margin and normal, at least: a value of 0 would say that the margin
/// lies on the surface.
constexpr double LeastCosine = 0.05;
/// Cosine that the second fit's normal keeps with the first's. On a lying cylinder 0.9 takes back
/// the rims, which cost 1% of the volume; 0.7 lets thin parts of a branching shape go.
constexpr double LeastAgreement = 0.8;
/// A margin that finds no room shrinks by this, down to this part of d.
constexpr double ShrinkStep = 0.7;
constexpr double LeastMargin = 0.05;

void Append(const ConstraintSet& from, std::size_t i, ConstraintSet& to)
{
  to.Points.push_back(from.Points[i]);
  to.Values.push_back(from.Values[i]);
  to.Kind.push_back(from.Kind[i]);
  to.Contour.push_back(from.Contour[i]);
}
}

RefinedMargins::RefinedMargins(const ContourSet& contours, const ConstraintSet& inPlane, bool unit)
  : Unit(unit)
{
  this->AddTips(contours, inPlane);
  this->Current = this->Start;
  this->ListVertices();
}

void RefinedMargins::AddTips(const ContourSet& contours, const ConstraintSet& inPlane)
{
  const std::vector<ContourTip> tips = FindTips(contours);
  this->TipContours.resize(tips.size(), 0);
  this->Start.MarginDistance = inPlane.MarginDistance;
  this->Start.LeftOut = inPlane.LeftOut;
  this->Start.Report = inPlane.Report;
  Point3 vertex{ 0, 0, 0 };
  for (std::size_t i = 0; i < inPlane.Points.size(); ++i)
  {
    const int contour = inPlane.Contour[i];
    const int side = contour >= 0 ? tips[contour].Side : 0;
    const int kind = inPlane.Kind[i];
    if (kind == ConstraintSet::Boundary)
    {
      vertex = inPlane.Points[i];
      this->Tips += side != 0 ? 1 : 0;
    }
    else if (side != 0 && !tips[contour].Flat)
    {
      continue;
    }
    Append(inPlane, i, this->Start);
    if (side != 0)
    {
      this->TipContours[contour] = 1;
    }
    if (side != 0 && kind != ConstraintSet::Boundary)
    {
      const double d = inPlane.MarginDistance;
      const Vector3& normal = contours.Levels[contours.Contours[contour].Level].Frame.Normal;
      this->Start.Points.back() = vertex + (kind * side * d) * normal;
      this->Start.Values.back() = kind * (this->Unit ? 1 : d);
    }
  }
}

void RefinedMargins::ListVertices()
{
  for (int i = 0; i < static_cast<int>(this->Start.Points.size()); ++i)
  {
    switch (this->Start.Kind[i])
    {
      case ConstraintSet::Boundary:
        this->All.emplace_back();
        this->All.back().Boundary = i;
        this->Places.push_back(this->Start.Points[i]);
        break;
      case ConstraintSet::Inner:
        this->All.back().Inner = i;
        break;
      default:
        this->All.back().Outer = i;
        break;
    }
  }
  for (Vertex& v : this->All)
  {
    const int contour = this->Start.Contour[v.Boundary];
    v.Fixed = (contour >= 0 && this->TipContours[contour]) || !this->CanTurn(v);
  }
}

double RefinedMargins::DistanceOf(const Vertex& vertex, int constraint) const
{
  return Norm(this->Start.Points[constraint] - this->Start.Points[vertex.Boundary]);
}

bool RefinedMargins::CanTurn(const Vertex& vertex) const
{
  if (vertex.Inner < 0 || vertex.Outer < 0)
  {
    return false;
  }
  const double inner = this->DistanceOf(vertex, vertex.Inner);
  const double outer = this->DistanceOf(vertex, vertex.Outer);
  return std::min(inner, outer) >= LeastRoom * this->Start.MarginDistance &&
    std::max(inner, outer) <= MostReach * this->Start.MarginDistance;
}

std::size_t RefinedMargins::Turned() const
{
  return static_cast<std::size_t>(
    std::count_if(this->All.begin(), this->All.end(), [](const Vertex& v) { return v.IsTurned; }));
}

void RefinedMargins::Turn(const ImplicitFunction& first, double part, int threads, Monitor& monitor)
{
  std::vector<double> values;
  std::vector<Vector3> gradients;
  const FunctionEvaluator evaluator(first, threads);
  evaluator.ValuesAndGradients(this->Places, values, gradients, monitor);
  const PointGrid grid(this->Places, this->Start.MarginDistance);
  for (std::size_t k = 0; k < this->All.size(); ++k)
  {
    Vertex& v = this->All[k];
    const double steep = Norm(gradients[k]);
    if (v.Fixed || !(steep > 0))
    {
      continue;
    }
    v.IsTurned = true;
    v.Normal = (1 / steep) * gradients[k];
    this->Refine(grid, k, part);
  }
}

void RefinedMargins::Refine(const PointGrid& grid, std::size_t k, double part)
{
  const Vertex& v = this->All[k];
  for (const int constraint : { v.Inner, v.Outer })
  {
    const double side = this->Start.Kind[constraint];
    const double distance = this->DistanceOf(v, constraint);
    const Vector3 inPlane =
      (1 / distance) * (this->Start.Points[constraint] - this->Start.Points[v.Boundary]);
    if (part == 0)
    {
      const double cosine = side * Dot(inPlane, v.Normal);
      this->Current.Values[constraint] =
        this->Unit ? side : this->Start.Values[constraint] * std::max(LeastCosine, cosine);
      continue;
    }
    const Vector3 between = (1 - part) * inPlane + (part * side) * v.Normal;
    const double length = Norm(between);
    if (length > 0)
    {
      this->PlaceMargin(grid, k, constraint, (1 / length) * between);
    }
  }
}

void RefinedMargins::PlaceMargin(
  const PointGrid& grid, std::size_t k, int constraint, const Vector3& way)
{
  const Vertex& v = this->All[k];
  const double d = this->Start.MarginDistance;
  const double side = this->Start.Kind[constraint];
  const double cosine = std::max(LeastCosine, side * Dot(way, v.Normal));
  for (double t = d; t >= LeastMargin * d; t *= ShrinkStep)
  {
    const Point3 place = this->Places[k] + t * way;
    const int nearest = grid.Nearest(place, t);
    // Rounding may leave the vertex itself a hair outside the radius.
    if (nearest < 0 || this->Places[nearest] == this->Places[k])
    {
      this->Current.Points[constraint] = place;
      this->Current.Values[constraint] = side * (this->Unit ? 1 : t * cosine);
      return;
    }
  }
}

std::size_t RefinedMargins::TakeBack(const ImplicitFunction& second, int threads, Monitor& monitor)
{
  const FunctionEvaluator evaluator(second, threads);
  const std::vector<double> atMargins = evaluator.Values(this->Start.Points, monitor);
  std::vector<double> atPlaces;
  std::vector<Vector3> gradients;
  evaluator.ValuesAndGradients(this->Places, atPlaces, gradients, monitor);
  std::size_t taken = 0;
  for (std::size_t k = 0; k < this->All.size(); ++k)
  {
    Vertex& v = this->All[k];
    if (!v.IsTurned ||
      (Dot(gradients[k], v.Normal) >= LeastAgreement * Norm(gradients[k]) &&
        atMargins[v.Inner] > 0 && atMargins[v.Outer] < 0))
    {
      continue;
    }
    // It is not turned again: what was contradicted once would be once more.
    v.IsTurned = false;
    v.Fixed = true;
    for (const int i : { v.Inner, v.Outer })
    {
      this->Current.Points[i] = this->Start.Points[i];
      this->Current.Values[i] = this->Start.Values[i];
    }
    ++taken;
  }
  return taken;
}
}
