// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/ZIPFile.h"

#include "Common/TracedFile.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace recon
{
namespace
{
// APPNOTE.TXT 4.3.7, 4.3.12 and 4.3.16: signatures, and sizes of the fixed parts.
constexpr std::string_view LocalHeader("PK\x03\x04", 4);
constexpr std::string_view DirectoryEntry("PK\x01\x02", 4);
constexpr std::string_view EndOfDirectory("PK\x05\x06", 4);
constexpr std::size_t LocalHeaderSize = 30;
constexpr std::size_t EntrySize = 46;
constexpr std::size_t EndSize = 22;
constexpr unsigned int Stored = 0;
constexpr unsigned int Deflated = 8;
constexpr unsigned int Encrypted = 1;
constexpr std::size_t LargestFile = std::size_t(256) << 20; // no drawing of a person is larger
// All files together may be so many times as large as the archive: outlines are about three times, and deflate ends
// at a thousand.
constexpr std::size_t MostInflation = 64;
constexpr std::size_t SmallestArchive = 4096; // what is smaller unpacks to nothing large

struct Entry
{
  std::string Name;
  unsigned int Flags = 0;
  unsigned int Method = 0;
  std::size_t Packed = 0;
  std::size_t Size = 0;
  std::size_t Header = 0;
};

/// Little-endian numbers; the caller has seen to it that they are there.
std::size_t Number(std::string_view bytes, std::size_t at, std::size_t count)
{
  std::size_t value = 0;
  for (std::size_t i = count; i > 0; --i)
  {
    value = (value << 8) | static_cast<unsigned char>(bytes[at + i - 1]);
  }
  return value;
}

bool Begins(std::string_view bytes, std::size_t at, std::string_view signature, std::size_t size)
{
  return at <= bytes.size() && size <= bytes.size() - at &&
    bytes.substr(at, signature.size()) == signature;
}

[[noreturn]] void FailFile(const std::string& fileName, const std::string& why)
{
  throw Error("Cannot read " + fileName + ": " + why);
}

std::vector<Entry> ReadDirectory(const std::string& fileName, std::string_view bytes)
{
  const std::size_t end = bytes.rfind(EndOfDirectory);
  if (end == std::string_view::npos || !Begins(bytes, end, EndOfDirectory, EndSize))
  {
    FailFile(fileName, "the archive has no directory at its end; it is truncated.");
  }
  const std::size_t count = Number(bytes, end + 10, 2);
  std::size_t at = Number(bytes, end + 16, 4);
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!Begins(bytes, at, DirectoryEntry, EntrySize))
    {
      FailFile(fileName,
        "entry " + std::to_string(i + 1) + " of " + std::to_string(count) +
          " of the archive's directory is damaged.");
    }
    const std::size_t nameLength = Number(bytes, at + 28, 2);
    Entry entry;
    entry.Name = std::string(bytes.substr(at + EntrySize, nameLength));
    entry.Flags = static_cast<unsigned int>(Number(bytes, at + 8, 2));
    entry.Method = static_cast<unsigned int>(Number(bytes, at + 10, 2));
    entry.Packed = Number(bytes, at + 20, 4);
    entry.Size = Number(bytes, at + 24, 4);
    entry.Header = Number(bytes, at + 42, 4);
    entries.push_back(std::move(entry));
    at += EntrySize + nameLength + Number(bytes, at + 30, 2) + Number(bytes, at + 32, 2);
  }
  return entries;
}

/// Entries that share bytes, or that unpack to very many, would take time and memory beyond any bound in the file's
/// size.
void CheckSizes(const std::string& fileName, std::size_t size, const std::vector<Entry>& entries)
{
  std::size_t packed = 0;
  std::size_t unpacked = 0;
  for (const Entry& entry : entries)
  {
    packed += entry.Packed;
    unpacked += entry.Method == Stored ? entry.Packed : entry.Size;
  }
  if (packed > size)
  {
    FailFile(
      fileName, "the archive's directory tells of more bytes than there are; it is damaged.");
  }
  if (unpacked > MostInflation * std::max(size, SmallestArchive))
  {
    FailFile(fileName,
      "the archive unpacks to more than " + std::to_string(MostInflation) +
        " times its size; it is damaged, or made to do harm.");
  }
}

/// Whether the packed bytes give so many and no other.
bool Inflate(std::string_view packed, std::string& content)
{
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK)
  {
    return false;
  }
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(content.data());
  stream.avail_out = static_cast<uInt>(content.size());
  const int status = inflate(&stream, Z_FINISH);
  inflateEnd(&stream);
  return status == Z_STREAM_END && stream.avail_out == 0;
}

/// What is wrong; empty where content is the file's.
std::string Unpack(std::string_view bytes, const Entry& entry, std::string& content)
{
  if (entry.Flags & Encrypted)
  {
    return "it is encrypted";
  }
  if (!Begins(bytes, entry.Header, LocalHeader, LocalHeaderSize))
  {
    return "it is not where the archive's directory says";
  }
  const std::size_t at = entry.Header + LocalHeaderSize + Number(bytes, entry.Header + 26, 2) +
    Number(bytes, entry.Header + 28, 2);
  if (at > bytes.size() || entry.Packed > bytes.size() - at)
  {
    return "it is truncated";
  }
  if (entry.Size > LargestFile)
  {
    return "it would be larger than 256 MB";
  }
  const std::string_view packed = bytes.substr(at, entry.Packed);
  if (entry.Method == Stored)
  {
    content = std::string(packed);
    return {};
  }
  if (entry.Method != Deflated)
  {
    return "it is packed in a way that is not known here (method " + std::to_string(entry.Method) +
      ")";
  }
  content.assign(entry.Size, '\0');
  return Inflate(packed, content) ? "" : "its packed bytes are damaged";
}
}

bool IsZIP(const std::string& start)
{
  return Begins(start, 0, LocalHeader, LocalHeader.size());
}

void ReadZIP(const std::string& fileName, const std::string& bytes,
  const std::function<void(const std::string&, const std::string&)>& take,
  std::vector<std::string>& report, Monitor& monitor)
{
  const std::vector<Entry> entries = ReadDirectory(fileName, bytes);
  CheckSizes(fileName, bytes.size(), entries);
  std::string content;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    monitor.Update(static_cast<double>(i) / static_cast<double>(entries.size()), "unpacking");
    const std::string wrong = Unpack(bytes, entries[i], content);
    if (wrong.empty())
    {
      take(entries[i].Name, content);
      continue;
    }
    report.push_back("\"" + CleanName(entries[i].Name) + "\": left out, " + wrong + ".");
  }
}
}
