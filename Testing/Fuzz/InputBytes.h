// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file InputBytes.h
 * @brief The bytes of an input as choices and numbers; zeros where they have come to an end.
 */
#ifndef InputBytes_h
#define InputBytes_h

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace fuzz
{
class InputBytes
{
public:
  explicit InputBytes(const std::string& bytes) : Bytes(bytes) {}

  bool AtEnd() const { return this->Position >= this->Bytes.size(); }

  int Byte()
  {
    return this->AtEnd() ? 0 : static_cast<unsigned char>(this->Bytes[this->Position++]);
  }

  /// 0 ... end - 1
  int Below(int end) { return this->Byte() % end; }
  /// from ... to, both of them
  int Between(int from, int to) { return from + this->Below(to - from + 1); }
  bool Flag() { return this->Byte() % 2 == 1; }

  /// -32768 ... 32767
  int Word()
  {
    const int high = this->Byte();
    return static_cast<std::int16_t>((high << 8) | this->Byte());
  }

  /// Any finite double.
  double Real()
  {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i)
    {
      bits = (bits << 8) | static_cast<std::uint64_t>(this->Byte());
    }
    double value = 0;
    static_assert(sizeof(value) == sizeof(bits));
    std::memcpy(&value, &bits, sizeof(value));
    return std::isfinite(value) ? value : 0;
  }

  template <typename T>
  T OneOf(const std::vector<T>& values)
  {
    return values[static_cast<std::size_t>(this->Below(static_cast<int>(values.size())))];
  }

  /// So many bytes, or as many as there are left.
  std::string Text(std::size_t size)
  {
    const std::string text =
      this->AtEnd() ? std::string() : this->Bytes.substr(this->Position, size);
    this->Position += text.size();
    return text;
  }

private:
  const std::string& Bytes;
  std::size_t Position = 0;
};
}

#endif
