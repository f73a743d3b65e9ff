// SPDX-License-Identifier: GPL-3.0-or-later
#include "FuzzTarget.h"

#include "Readers/Soundness.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

namespace fuzz
{
namespace
{
class Folder
{
public:
  Folder()
    : Path(std::filesystem::temp_directory_path() /
        ("contour-fuzz-" + std::to_string(std::random_device()())))
  {
    std::filesystem::create_directories(this->Path);
  }
  ~Folder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->Path, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const std::filesystem::path Path;
};
}

void Require(bool holds, const std::string& words)
{
  if (!holds)
  {
    std::fprintf(stderr, "FINDING: %s\n", words.c_str());
    std::abort();
  }
}

std::string Name(const std::string& name)
{
  static const Folder folder;
  return (folder.Path / name).string();
}

std::string File(const std::string& bytes, const std::string& name)
{
  const std::string path = Name(name);
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  Require(file.good(), "the input cannot be written to " + path);
  return path;
}

std::string Bytes(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  try
  {
    fuzz::Try(std::string(reinterpret_cast<const char*>(data), size));
  }
  catch (const recon::Error& error)
  {
    fuzz::RequireNone(readertesting::FaultOf(std::string(error.what())));
  }
  return 0;
}
