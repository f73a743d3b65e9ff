// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file NamedMonitor.h
 * @brief Progress under one name, as steps that are done again and again say nothing to a user.
 */
#ifndef recon_NamedMonitor_h
#define recon_NamedMonitor_h

#include "Base/SubMonitor.h"

#include <cstddef>
#include <string>
#include <utility>

namespace recon
{
/**
 * @class NamedMonitor
 * @brief A SubMonitor that tells its own name instead of those of its steps: "fitting, 2 of 3".
 */
class NamedMonitor final : public Monitor
{
public:
  NamedMonitor(Monitor& parent, double from, double to, std::string name)
    : Share(parent, from, to),
      Name(std::move(name))
  {
  }

  /// One of several passes that share the progress alike, the first being pass 0.
  static NamedMonitor Pass(
    Monitor& parent, std::size_t pass, std::size_t all, const std::string& name)
  {
    const auto count = static_cast<double>(all);
    return { parent, static_cast<double>(pass) / count, static_cast<double>(pass + 1) / count,
      name + ", " + std::to_string(pass + 1) + " of " + std::to_string(all) };
  }

  bool AbortRequested() override { return this->Share.AbortRequested(); }

protected:
  void OnProgress(double fraction, const char*) override
  {
    this->Share.Update(fraction, this->Name.c_str());
  }

private:
  SubMonitor Share;
  std::string Name;
};
}

#endif
