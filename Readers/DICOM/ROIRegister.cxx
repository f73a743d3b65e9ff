// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/ROIRegister.h"

#include "DICOM/DICOMText.h"

#include <algorithm>

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
    wanted = this->Numbers.empty() ? 1 : std::max(0, *this->Numbers.rbegin()) + 1;
  }
  this->Numbers.insert(wanted);
  return wanted;
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
