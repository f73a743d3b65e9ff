// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file BinaryScanner.h
 * @brief Bytes as numbers of big-endian formats, with errors that name file and place.
 */
#ifndef recon_BinaryScanner_h
#define recon_BinaryScanner_h

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace recon
{
/**
 * Reads on from byte to byte. Nothing is ever read beyond the end: what is missing is an Error that
 * says what was expected and where. Counts are checked against the bytes that are left before
 * anybody allocates for them.
 */
class BinaryScanner
{
public:
  /// bytes must outlive the scanner; name is what errors call them.
  BinaryScanner(std::string name, std::string_view bytes);

  std::size_t BytesLeft() const { return this->Bytes.size() - this->Position; }
  std::size_t GetPosition() const { return this->Position; }
  double GetFraction() const;

  std::string_view Take(std::size_t count, const char* what);
  void Skip(std::size_t count, const char* what) { this->Take(count, what); }
  /// @throws Error where the position is beyond the end.
  void MoveTo(std::size_t position, const char* what);

  std::int32_t Int32(const char* what);
  std::uint32_t UInt32(const char* what);
  std::int16_t Int16(const char* what);
  std::uint16_t UInt16(const char* what);
  unsigned char Byte(const char* what);
  float Float(const char* what);
  /// A count of things that take so many bytes each.
  std::size_t Count(const char* what, std::size_t bytesEach);

  [[noreturn]] void Fail(const std::string& sentence) const;

private:
  std::uint32_t Unsigned(std::size_t bytes, const char* what);

  std::string Name;
  std::string_view Bytes;
  std::size_t Position = 0;
};
}

#endif
