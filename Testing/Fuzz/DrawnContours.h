// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file DrawnContours.h
 * @brief Contours, and the options of the methods, out of the bytes of an input.
 *
 * A byte is a corner where it can be, so that a mutation moves a corner, and few bytes make much: corners that are
 * shared, in line, or a rounding apart; contours that are repeated from level to level; slices of any spacing.
 */
#ifndef DrawnContours_h
#define DrawnContours_h

#include "InputBytes.h"

#include "Contours/ContourSetBuilder.h"
#include "Polyhedral/PolyhedralOptions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace fuzz
{
using Ring = std::vector<recon::Point2>;

/// What DrawPolyhedralOptions takes at most.
constexpr std::size_t BytesOfOptions = 18;

class DrawnRings
{
public:
  explicit DrawnRings(InputBytes& bytes) : Bytes(bytes), Style(bytes.Below(8)) {}

  /// Those of a plane; some are the last plane's again.
  std::vector<Ring> Next()
  {
    std::vector<Ring> rings;
    const int count = this->Bytes.Below(5);
    for (int i = 0; i < count; ++i)
    {
      const bool isRepeated = this->Bytes.Below(4) == 0 && !this->Last.empty();
      rings.push_back(isRepeated ? this->Bytes.OneOf(this->Last) : this->Draw());
    }
    this->Last = rings.empty() ? this->Last : rings;
    return rings;
  }

private:
  Ring Draw()
  {
    Ring ring;
    const int count = this->Bytes.Between(1, 12);
    for (int i = 0; i < count; ++i)
    {
      ring.push_back(this->Corner());
    }
    return ring;
  }

  recon::Point2 Corner()
  {
    const double x = this->Coordinate();
    return { x, this->Coordinate() };
  }

  double Coordinate()
  {
    static const std::vector<double> beside{ 0, 0, 0, 0.1, 0.02, 1e-3, 1e-6, 1e-9, 1e-12 };
    const int byte = this->Bytes.Byte();
    switch (this->Style)
    {
      case 0:
        return byte % 8;
      case 1:
        return byte - 128;
      case 2:
        return 0.1 * byte;
      case 3:
        return 0.1 * (byte / 16) + 0.1 * (byte % 16); // .1 + .2 is not .3
      case 4:
        return byte % 8 + this->Bytes.OneOf(beside);
      case 5:
        return 1e9 + byte / 3.0;
      case 6:
        return (byte - 128) * std::pow(10, this->Bytes.Between(-6, 6));
      default:
        return byte < 16 ? this->Bytes.Real() : byte + this->Bytes.Word() / 32768.0;
    }
  }

  InputBytes& Bytes;
  const int Style;
  std::vector<Ring> Last;
};

/// A chain, as a file may have it: whole, with its first point again, cut in pieces, open.
inline void Append(recon::LoopSoup& soup, std::vector<recon::Point3> points, InputBytes& bytes)
{
  const int how = bytes.Below(12);
  if (how == 0)
  {
    points.push_back(points.front());
  }
  if (how == 1)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      soup.Append({ points[i], points[(i + 1) % points.size()] }, false);
    }
    return;
  }
  soup.Append(points, how != 2);
  soup.Chains.back().ExclusiveOr = how == 3;
}

/// Contours on planes of one height each.
inline recon::LoopSoup DrawStack(InputBytes& bytes)
{
  static const std::vector<double> thicknesses{ 1, 1, 0.1, 1e-3, 5e-5, 30, 1e-9, 1e6 };
  static const std::vector<double> shares{ 1, 1, 1, 1, 0.5, 2, 20, 0.04, 0 };
  recon::LoopSoup soup;
  double height = bytes.OneOf(std::vector<double>{ 0, 0, 0.0005, -250.25, 1e9 });
  const double thickness = bytes.OneOf(thicknesses);
  soup.Millimetres = bytes.Flag();
  DrawnRings rings(bytes);
  const int levels = bytes.Between(2, 7);
  for (int level = 0; level < levels && !bytes.AtEnd(); ++level)
  {
    for (const Ring& ring : rings.Next())
    {
      std::vector<recon::Point3> points;
      for (const recon::Point2& p : ring)
      {
        points.push_back({ p[0], p[1], height });
      }
      Append(soup, points, bytes);
    }
    height += thickness * bytes.OneOf(shares);
  }
  return soup;
}

/// Contours on planes of any direction through a place near the origin.
inline recon::LoopSoup DrawNetwork(InputBytes& bytes)
{
  using recon::operator+;
  using recon::operator*;
  recon::LoopSoup soup;
  DrawnRings rings(bytes);
  const int planes = bytes.Between(2, 5);
  for (int plane = 0; plane < planes && !bytes.AtEnd(); ++plane)
  {
    // The axes, or any direction; a frame that is not quite orthonormal only stretches the rings.
    const int axis = bytes.Below(4);
    recon::Vector3 u{ 0, 0, 0 };
    recon::Vector3 v{ 0, 0, 0 };
    if (axis < 3)
    {
      u[static_cast<std::size_t>((axis + 1) % 3)] = 1;
      v[static_cast<std::size_t>((axis + 2) % 3)] = 1;
    }
    else
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        u[a] = (bytes.Byte() - 128) / 64.0;
        v[a] = (bytes.Byte() - 128) / 64.0;
      }
    }
    const recon::Vector3 normal = recon::Cross(u, v);
    const double offset = (bytes.Byte() - 128) / 16.0;
    for (const Ring& ring : rings.Next())
    {
      std::vector<recon::Point3> points;
      for (const recon::Point2& p : ring)
      {
        points.push_back(offset * normal + p[0] * u + p[1] * v);
      }
      Append(soup, points, bytes);
    }
  }
  return soup;
}

inline recon::ContourSetOptions DrawSetOptions(InputBytes& bytes)
{
  recon::ContourSetOptions options;
  options.PlaneTolerance = bytes.OneOf(std::vector<double>{ 0, 0, 0, 1e-6, 0.1, 1e3 });
  options.SnapTolerance = bytes.OneOf(std::vector<double>{ 0, 0, 0, 1e-9, 1e-2, 10 });
  options.Holes = static_cast<recon::HoleRule>(bytes.Below(4));
  options.OpenLines = static_cast<recon::OpenLineRule>(bytes.Below(3));
  return options;
}

inline recon::PolyhedralOptions DrawPolyhedralOptions(InputBytes& bytes, int contours)
{
  using Options = recon::PolyhedralOptions;
  Options options;
  const int flags = bytes.Byte();
  options.InternalPoints = flags % 4 != 0;
  options.LiftInternalPoints = flags / 4 % 4 != 0;
  options.Mapping = flags / 16 % 4 == 0 ? Options::Proximity : Options::Overlap;
  options.EndCaps = static_cast<Options::EndCapsType>(bytes.Below(4));
  options.IsolatedContours = bytes.Flag() ? Options::Extrude : Options::Drop;
  options.OverlapThreshold = bytes.OneOf(std::vector<double>{ 0.1, 0.1, 0, 0.5, 0.99 });
  options.MaximumGap = bytes.OneOf(std::vector<double>{ 5, 5, 0, 1, 100 });
  options.AlignLevels = static_cast<recon::LevelAlignmentMode>(bytes.Below(3));
  options.PinchGap = bytes.OneOf(std::vector<double>{ 1e-3, 1e-3, 0, 0.1 });
  for (int joins = bytes.Below(8); joins > 4; --joins)
  {
    auto& pairs = bytes.Flag() ? options.ForcedJoins : options.ForbiddenJoins;
    const int first = bytes.Below(contours);
    pairs.emplace_back(first, bytes.Below(contours));
  }
  options.Threads = 1;
  return options;
}
}

#endif
