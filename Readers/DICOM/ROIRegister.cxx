// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/ROIRegister.h"

#include "DICOM/DICOMText.h"

#include <algorithm>
#include <limits>

namespace recon
{
namespace
{
std::string Folded(std::string name)
{
  for (char& c : name)
  {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return name;
}
}

void ROIRegister::Take(int number, const std::string& name)
{
  this->Numbers.insert(number);
  this->Names.insert(Folded(name));
}

int ROIRegister::NewNumber(int wanted)
{
  if (wanted <= 0 || this->Numbers.count(wanted) > 0)
  {
    const int last = this->Numbers.empty() ? 0 : std::max(0, *this->Numbers.rbegin());
    wanted = last == std::numeric_limits<int>::max() ? this->FirstFree() : last + 1;
  }
  this->Numbers.insert(wanted);
  return wanted;
}

int ROIRegister::FirstFree() const
{
  int free = 1;
  for (auto taken = this->Numbers.lower_bound(free); taken != this->Numbers.end() && *taken == free;
       ++taken)
  {
    ++free;
  }
  return free;
}

std::string ROIRegister::NewName(const std::string& wanted)
{
  std::string name = wanted;
  for (int n = 2; !this->Names.insert(Folded(name)).second; ++n)
  {
    const std::string suffix = " (" + std::to_string(n) + ")";
    name = DICOMText(wanted, LongestROIName - suffix.size()) + suffix;
  }
  return name;
}
}
