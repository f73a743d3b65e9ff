// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/DecimalString.h"

#include <charconv>
#include <string_view>

namespace recon
{
void AppendDecimalString(std::string& text, double value)
{
  constexpr int decimals = 6;
  char digits[32];
  const auto end =
    std::to_chars(digits, digits + sizeof(digits), value, std::chars_format::fixed, decimals);
  std::string_view number(digits, static_cast<std::size_t>(end.ptr - digits));
  number.remove_suffix(number.size() - 1 - number.find_last_not_of('0'));
  if (number.back() == '.')
  {
    number.remove_suffix(1);
  }
  text += number == "-0" ? std::string_view("0") : number;
}
}
