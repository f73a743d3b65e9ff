// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/BinaryScanner.h"

#include "Base/Monitor.h"

#include <cstring>
#include <utility>

namespace recon
{
BinaryScanner::BinaryScanner(std::string name, std::string_view bytes)
  : Name(std::move(name)),
    Bytes(bytes)
{
}

double BinaryScanner::GetFraction() const
{
  return this->Bytes.empty()
    ? 1.0
    : static_cast<double>(this->Position) / static_cast<double>(this->Bytes.size());
}

std::string_view BinaryScanner::Take(std::size_t count, const char* what)
{
  if (count > this->BytesLeft())
  {
    this->Fail("the file ends within " + std::string(what) + "; it is truncated.");
  }
  const std::string_view taken = this->Bytes.substr(this->Position, count);
  this->Position += count;
  return taken;
}

void BinaryScanner::MoveTo(std::size_t position, const char* what)
{
  if (position > this->Bytes.size())
  {
    this->Fail(std::string(what) + " would lie beyond the end of the file; it is truncated.");
  }
  this->Position = position;
}

std::uint32_t BinaryScanner::Unsigned(std::size_t bytes, const char* what)
{
  std::uint32_t value = 0;
  for (const char byte : this->Take(bytes, what))
  {
    value = (value << 8) | static_cast<unsigned char>(byte);
  }
  return value;
}

std::uint32_t BinaryScanner::UInt32(const char* what)
{
  return this->Unsigned(4, what);
}

std::int32_t BinaryScanner::Int32(const char* what)
{
  return static_cast<std::int32_t>(this->Unsigned(4, what));
}

std::uint16_t BinaryScanner::UInt16(const char* what)
{
  return static_cast<std::uint16_t>(this->Unsigned(2, what));
}

std::int16_t BinaryScanner::Int16(const char* what)
{
  return static_cast<std::int16_t>(this->UInt16(what));
}

unsigned char BinaryScanner::Byte(const char* what)
{
  return static_cast<unsigned char>(this->Unsigned(1, what));
}

float BinaryScanner::Float(const char* what)
{
  const std::uint32_t bits = this->Unsigned(4, what);
  float value = 0;
  static_assert(sizeof(value) == sizeof(bits));
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

std::size_t BinaryScanner::Count(const char* what, std::size_t bytesEach)
{
  const std::int32_t count = this->Int32(what);
  if (count < 0 || static_cast<std::size_t>(count) > this->BytesLeft() / bytesEach)
  {
    this->Fail(std::string(what) + " is " + std::to_string(count) +
      ", more than the rest of the file can hold; it is truncated or the count is wrong.");
  }
  return static_cast<std::size_t>(count);
}

void BinaryScanner::Fail(const std::string& sentence) const
{
  throw Error(
    "Cannot read " + this->Name + ", byte " + std::to_string(this->Position) + ": " + sentence);
}
}
