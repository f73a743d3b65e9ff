// SPDX-License-Identifier: GPL-3.0-or-later
#include "Reconstruct/SectionTransform.h"

#include "Common/TextScanner.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace recon
{
namespace
{
constexpr int MostSteps = 50;      // Newton's method takes some five; more never helped
constexpr double Accuracy = 1e-12; // of the coordinates' size, where it ends

/// Solves [a b; c d] (x, y) = (p, q); returns false where the matrix has no inverse.
bool SolvePair(double a, double b, double c, double d, const Point2& right, Point2& solution)
{
  const double determinant = a * d - b * c;
  const double size = std::max(std::abs(a * d), std::abs(b * c));
  if (!(std::abs(determinant) > 1e-14 * size))
  {
    return false;
  }
  solution = { (right[0] * d - b * right[1]) / determinant,
    (a * right[1] - right[0] * c) / determinant };
  return std::isfinite(solution[0]) && std::isfinite(solution[1]);
}
}

SectionTransform SectionTransform::FromInverse(
  const std::array<double, 6>& x, const std::array<double, 6>& y)
{
  SectionTransform transform;
  transform.IsInverse = true;
  transform.X = x;
  transform.Y = y;
  return transform;
}

SectionTransform SectionTransform::FromAffine(const std::array<double, 6>& t)
{
  SectionTransform transform;
  transform.X = { t[2], t[0], t[1], 0, 0, 0 };
  transform.Y = { t[5], t[3], t[4], 0, 0, 0 };
  return transform;
}

Point2 SectionTransform::Evaluate(const Point2& p) const
{
  const double terms[] = { 1, p[0], p[1], p[0] * p[1], p[0] * p[0], p[1] * p[1] };
  Point2 value{ 0, 0 };
  for (std::size_t i = 0; i < 6; ++i)
  {
    value[0] += this->X[i] * terms[i];
    value[1] += this->Y[i] * terms[i];
  }
  return value;
}

bool SectionTransform::Place(const Point2& trace, Point2& place) const
{
  if (this->IsInverse)
  {
    return this->Solve(trace, place);
  }
  place = this->Evaluate(trace);
  return std::isfinite(place[0]) && std::isfinite(place[1]);
}

bool SectionTransform::Solve(const Point2& trace, Point2& place) const
{
  // The affine part alone is where Newton's method starts; for an affine transform that is it.
  const std::array<double, 6>& a = this->X;
  const std::array<double, 6>& b = this->Y;
  if (!SolvePair(a[1], a[2], b[1], b[2], { trace[0] - a[0], trace[1] - b[0] }, place))
  {
    return false;
  }
  if (std::all_of(a.begin() + 3, a.end(), [](double c) { return c == 0; }) &&
    std::all_of(b.begin() + 3, b.end(), [](double c) { return c == 0; }))
  {
    return true;
  }
  for (int step = 0; step < MostSteps; ++step)
  {
    const double x = place[0];
    const double y = place[1];
    const Point2 reached = this->Evaluate(place);
    Point2 correction{};
    if (!SolvePair(a[1] + a[3] * y + 2 * a[4] * x, a[2] + a[3] * x + 2 * a[5] * y,
          b[1] + b[3] * y + 2 * b[4] * x, b[2] + b[3] * x + 2 * b[5] * y,
          { trace[0] - reached[0], trace[1] - reached[1] }, correction))
    {
      return false;
    }
    place = { x + correction[0], y + correction[1] };
    const double size = 1 + std::abs(x) + std::abs(y);
    if (std::abs(correction[0]) + std::abs(correction[1]) <= Accuracy * size)
    {
      return std::isfinite(place[0]) && std::isfinite(place[1]);
    }
  }
  return false;
}

bool ParseCoefficients(const std::string& text, std::array<double, 6>& numbers)
{
  std::istringstream words(text);
  std::string word;
  std::size_t count = 0;
  while (words >> word)
  {
    if (count == numbers.size() || !ParseNumber(word, numbers[count++]))
    {
      return false;
    }
  }
  return count == numbers.size();
}
}
