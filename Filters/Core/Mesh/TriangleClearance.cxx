// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/TriangleClearance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace recon
{
namespace
{
/// A difference of coordinates is rounded once, its product with a direction three times more; with room to spare.
constexpr double Roundings = 32 * std::numeric_limits<double>::epsilon();

class Pair
{
public:
  Pair(const std::array<Point3, 3>& s, const std::array<Point3, 3>& t, double distance) : S(s), T(t)
  {
    double largest = 0;
    for (const auto* corners : { &s, &t })
    {
      for (const Point3& p : *corners)
      {
        largest = std::max({ largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
      }
    }
    this->Room = (1 + Roundings) * distance + Roundings * largest;
    for (std::size_t k = 0; k < 3; ++k)
    {
      this->SidesOfS[k] = s[(k + 1) % 3] - s[k];
      this->SidesOfT[k] = t[(k + 1) % 3] - t[k];
    }
  }

  bool ArePartedWithRoom() const
  {
    const Vector3 normalOfS = Cross(this->SidesOfS[0], this->SidesOfS[1]);
    const Vector3 normalOfT = Cross(this->SidesOfT[0], this->SidesOfT[1]);
    if (this->HasRoomAlong(normalOfS) || this->HasRoomAlong(normalOfT))
    {
      return true;
    }
    for (const Vector3& side : this->SidesOfS)
    {
      if (this->HasRoomAlong(Cross(side, normalOfS)))
      {
        return true;
      }
      for (const Vector3& other : this->SidesOfT)
      {
        if (this->HasRoomAlong(Cross(side, other)))
        {
          return true;
        }
      }
    }
    return std::any_of(this->SidesOfT.begin(), this->SidesOfT.end(),
      [&](const Vector3& side) { return this->HasRoomAlong(Cross(side, normalOfT)); });
  }

private:
  bool HasRoomAlong(const Vector3& direction) const
  {
    const double length = Norm(direction);
    if (!(length > 0) || !std::isfinite(length))
    {
      return false;
    }
    const Vector3 unit = (1 / length) * direction;
    double lowS = 0, highS = 0;
    double lowT = std::numeric_limits<double>::infinity(), highT = -lowT;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double ofS = Dot(unit, this->S[k] - this->S[0]);
      const double ofT = Dot(unit, this->T[k] - this->S[0]);
      lowS = std::min(lowS, ofS);
      highS = std::max(highS, ofS);
      lowT = std::min(lowT, ofT);
      highT = std::max(highT, ofT);
    }
    // A direction as short as the least numbers is no unit vector.
    const bool isUnit = std::abs(Dot(unit, unit) - 1) < 1e-6;
    return isUnit && (1 - 1e-6) * std::max(lowT - highS, lowS - highT) > this->Room;
  }

  const std::array<Point3, 3>& S;
  const std::array<Point3, 3>& T;
  double Room;
  std::array<Vector3, 3> SidesOfS{};
  std::array<Vector3, 3> SidesOfT{};
};
}

bool AreFartherApartThan(
  const std::array<Point3, 3>& s, const std::array<Point3, 3>& t, double distance)
{
  return Pair(s, t, distance).ArePartedWithRoom();
}
}
