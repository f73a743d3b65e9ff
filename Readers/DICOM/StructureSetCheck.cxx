// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/StructureSetCheck.h"

#include "Base/Text.h"
#include "DICOM/DecimalString.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <utility>

namespace recon
{
namespace
{
/// Above what planning systems round the coordinates of tilted contours to, below any slice, mm.
constexpr double PlanarTolerance = 0.05;

bool IsClosed(const WrittenContour& contour)
{
  return contour.GeometricType == "CLOSED_PLANAR" || contour.GeometricType == "CLOSEDPLANAR_XOR";
}

/// The largest distance from the plane that fits best (least squares); 0 for what lies in a line.
double RoughnessOf(const std::vector<Point3>& points)
{
  Eigen::MatrixX3d centred(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    centred.row(static_cast<Eigen::Index>(i)) << points[i][0], points[i][1], points[i][2];
  }
  centred.rowwise() -= centred.colwise().mean().eval();
  const Eigen::Matrix3d moments = centred.transpose() * centred / double(points.size());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(moments);
  return (centred * axes.eigenvectors().col(0)).cwiseAbs().maxCoeff();
}

/// Whether a contour can be written; noted where it is too little, or an open one is not as planar
/// as its type says, which is corrected. @throws Error where it is wrong.
bool IsContour(WrittenContour& contour, const std::string& roi, std::vector<std::string>& report)
{
  const std::string where = "ROI \"" + roi + "\", " + contour.Where;
  for (const Point3& p : contour.Points)
  {
    for (const double x : p)
    {
      if (!std::isfinite(x))
      {
        throw Error("Cannot write " + where + ": a coordinate is not a number.");
      }
      if (std::abs(x) > LargestCoordinate)
      {
        throw Error("Cannot write " + where +
          ": a coordinate is beyond 100 km; DICOM's are millimetres of a patient.");
      }
    }
  }
  const std::size_t least = contour.GeometricType == "POINT" ? 1 : IsClosed(contour) ? 3 : 2;
  if (contour.Points.size() < least)
  {
    report.push_back(where + ": left out, " + std::to_string(contour.Points.size()) +
      " points are no contour of type " + contour.GeometricType + ".");
    return false;
  }
  if (contour.GeometricType == "OPEN_NONPLANAR")
  {
    return true;
  }
  const double roughness = RoughnessOf(contour.Points);
  if (roughness > PlanarTolerance && contour.GeometricType == "OPEN_PLANAR")
  {
    contour.GeometricType = "OPEN_NONPLANAR";
    report.push_back(where + ": written as OPEN_NONPLANAR, a point lies " + Text(roughness) +
      " mm off its plane.");
    return true;
  }
  if (roughness > PlanarTolerance)
  {
    throw Error("Cannot write " + where + ": it is not planar, a point lies " + Text(roughness) +
      " mm off its plane, and DICOM has closed contours in planes only.");
  }
  return true;
}
}

void CheckContours(WrittenROI& roi, bool exclusiveOr, std::vector<std::string>& report)
{
  std::vector<WrittenContour> kept;
  for (WrittenContour& contour : roi.Contours)
  {
    if (IsContour(contour, roi.Description.Name, report))
    {
      kept.push_back(std::move(contour));
    }
  }
  roi.Contours = std::move(kept);
  // One contour of this kind makes all of its ROI so (PS3.3 C.8.8.6.3).
  exclusiveOr = exclusiveOr ||
    std::any_of(roi.Contours.begin(), roi.Contours.end(),
      [](const WrittenContour& contour) { return contour.GeometricType == "CLOSEDPLANAR_XOR"; });
  for (WrittenContour& contour : roi.Contours)
  {
    if (exclusiveOr && IsClosed(contour))
    {
      contour.GeometricType = "CLOSEDPLANAR_XOR";
    }
  }
  if (roi.Contours.empty())
  {
    report.push_back("ROI \"" + roi.Description.Name + "\": left out, it has no contours.");
  }
}
}
