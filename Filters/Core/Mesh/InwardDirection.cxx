// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/InwardDirection.h"

#include <algorithm>

namespace recon
{
namespace
{
/// Steps of the search for a direction on the inner side of all faces of a fan.
constexpr int DirectionSteps = 64;
}

Vector3 InwardOf(const std::vector<Vector3>& normals, double& clearance)
{
  Vector3 direction{ 0, 0, 0 };
  for (const Vector3& normal : normals)
  {
    direction = direction - normal;
  }
  Vector3 best{ 0, 0, 0 };
  clearance = -2;
  for (int step = 0; step < DirectionSteps; ++step)
  {
    const double length = Norm(direction);
    if (!(length > 0))
    {
      break;
    }
    const Vector3 unit = (1 / length) * direction;
    const auto worst = std::max_element(normals.begin(), normals.end(),
      [&](const Vector3& a, const Vector3& b) { return Dot(a, unit) < Dot(b, unit); });
    if (-Dot(*worst, unit) > clearance)
    {
      clearance = -Dot(*worst, unit);
      best = unit;
    }
    // Away from the plane that is nearest, by less and less.
    direction = unit - (1.0 / (2 + step)) * *worst;
  }
  return best;
}
}
