// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Solver/AvailableMemory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

namespace recon
{
namespace
{
constexpr double OtherwiseGigabytes = 8; ///< where the system does not tell

std::optional<double> NumberIn(const std::string& file)
{
  std::ifstream stream(file);
  double number = 0;
  // "max", no limit, is no number.
  if (stream >> number)
  {
    return number;
  }
  return std::nullopt;
}

std::optional<double> KernelSays()
{
  std::ifstream stream("/proc/meminfo");
  std::string line;
  while (std::getline(stream, line))
  {
    if (line.rfind("MemAvailable:", 0) == 0)
    {
      return 1024e-9 * std::stod(line.substr(line.find(':') + 1));
    }
  }
  return std::nullopt;
}

/// Pages of files that the group would give back.
double Reclaimable(const std::string& file)
{
  std::ifstream stream(file);
  std::string name;
  double bytes = 0;
  while (stream >> name >> bytes)
  {
    if (name == "inactive_file" || name == "total_inactive_file")
    {
      return bytes;
    }
  }
  return 0;
}

/// Version 2 of control groups, then version 1; as a container sees its own.
std::optional<double> GroupLeaves()
{
  const std::string two = "/sys/fs/cgroup/";
  const std::string one = "/sys/fs/cgroup/memory/";
  auto limit = NumberIn(two + "memory.max");
  auto used = NumberIn(two + "memory.current");
  std::string stat = two + "memory.stat";
  if (!limit || !used)
  {
    limit = NumberIn(one + "memory.limit_in_bytes");
    used = NumberIn(one + "memory.usage_in_bytes");
    stat = one + "memory.stat";
  }
  if (!limit || !used)
  {
    return std::nullopt;
  }
  return 1e-9 * std::max(0.0, *limit - *used + Reclaimable(stat));
}
}

double AvailableGigabytes()
{
  const double none = std::numeric_limits<double>::max();
  const double least = std::min(KernelSays().value_or(none), GroupLeaves().value_or(none));
  return least < none ? least : OtherwiseGigabytes;
}
}
