// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/ContourSamples.h"

#include "Base/Angles.h"

#include <algorithm>

namespace recon
{
namespace
{
/// An edge that is as long as a whole contour set is never cut into more pieces than this.
constexpr int MostPieces = 1000;

Vector3 Unit(const Vector3& v)
{
  const double length = Norm(v);
  return length > 0 ? (1 / length) * v : Vector3{ 0, 0, 0 };
}

class Sampler
{
public:
  Sampler(const ContourSet& contours, const TriangleMesh& through, double distance)
    : Contours(contours),
      Known(through.Points),
      Distance(distance)
  {
    std::sort(this->Known.begin(), this->Known.end());
  }

  void Add(const Contour& contour)
  {
    const std::size_t count = contour.Points.size();
    double length = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      length += Norm(this->At(contour.Points[(i + 1) % count]) - this->At(contour.Points[i]));
    }
    this->Radius = length / (2 * Pi);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->AddVertex(contour, contour.Points[(i + count - 1) % count], contour.Points[i],
        contour.Points[(i + 1) % count]);
    }
  }

  std::vector<ContourSample> Samples;

private:
  const Point3& At(int p) const { return this->Contours.Points[p]; }

  bool IsKnown(int p) const
  {
    return std::binary_search(this->Known.begin(), this->Known.end(), this->At(p));
  }

  /// Contours have the solid on their left.
  Vector3 RightOf(const Contour& contour, const Point3& from, const Point3& to) const
  {
    return Unit(Cross(to - from, this->Contours.Levels[contour.Level].Frame.Normal));
  }

  int PiecesOf(const Point3& from, const Point3& to) const
  {
    return static_cast<int>(
      std::min<double>(MostPieces, std::max(1.0, std::ceil(Norm(to - from) / this->Distance))));
  }

  void AddVertex(const Contour& contour, int before, int p, int after)
  {
    const Point3& a = this->At(before);
    const Point3& b = this->At(p);
    const Point3& c = this->At(after);
    if (!this->IsKnown(p))
    {
      return;
    }
    const int pieces = this->PiecesOf(b, c);
    const double length = 0.5 * (Norm(b - a) / this->PiecesOf(a, b) + Norm(c - b) / pieces);
    const Vector3 right = this->RightOf(contour, b, c);
    this->Samples.push_back(
      { b, Unit(this->RightOf(contour, a, b) + right), length, contour.Level, true, this->Radius });
    for (int k = 1; k < pieces && this->IsKnown(after); ++k)
    {
      const double t = static_cast<double>(k) / pieces;
      this->Samples.push_back(
        { b + t * (c - b), right, Norm(c - b) / pieces, contour.Level, false, this->Radius });
    }
  }

  const ContourSet& Contours;
  std::vector<Point3> Known;
  double Distance;
  double Radius = 0; ///< of the contour that is added
};
}

std::vector<ContourSample> SampleContours(
  const ContourSet& contours, const TriangleMesh& through, double distance)
{
  Sampler sampler(contours, through, distance);
  for (const Contour& contour : contours.Contours)
  {
    sampler.Add(contour);
  }
  return std::move(sampler.Samples);
}
}
