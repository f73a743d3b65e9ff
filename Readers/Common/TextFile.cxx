// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/TextFile.h"

#include "Base/Monitor.h"
#include "Common/ReplacedFile.h"

#include <charconv>
#include <filesystem>
#include <fstream>

namespace recon
{
std::string ReadTextFile(const std::string& fileName)
{
  std::error_code status;
  const std::filesystem::path path(fileName);
  if (!std::filesystem::is_regular_file(path, status))
  {
    throw Error("Cannot read " + fileName + ": there is no such file.");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    throw Error("Cannot read " + fileName + ": it cannot be opened (permissions?).");
  }
  const auto size = std::filesystem::file_size(path, status);
  if (status)
  {
    throw Error("Cannot read " + fileName + ": " + status.message() + ".");
  }
  std::string text(static_cast<std::size_t>(size), '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.gcount() != static_cast<std::streamsize>(text.size()))
  {
    throw Error("Cannot read " + fileName + ": the file ended while it was read.");
  }
  return text;
}

void WriteTextFile(const std::string& fileName, const std::string& text)
{
  ReplacedFile replaced(fileName);
  std::ofstream file(replaced.GetPart(), std::ios::binary | std::ios::trunc);
  if (!file)
  {
    throw Error("Cannot write " + fileName + ": its folder cannot be written to.");
  }
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  if (!file)
  {
    throw Error("Cannot write " + fileName + ": the disk may be full.");
  }
  replaced.Commit();
}

void AppendNumber(std::string& text, double value)
{
  char digits[32];
  const auto result = std::to_chars(digits, digits + sizeof(digits), value);
  text.append(digits, result.ptr);
}
}
