// SPDX-License-Identifier: GPL-3.0-or-later
// A fuzz target without libFuzzer: tries every file of the folders that are given, in order.
#include "FuzzTarget.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

int main(int count, char** arguments)
{
  std::vector<std::string> files;
  for (int i = 1; i < count; ++i)
  {
    if (!std::filesystem::is_directory(arguments[i]))
    {
      files.emplace_back(arguments[i]);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(arguments[i]))
    {
      files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  for (const std::string& file : files)
  {
    // Said before, so that it is known which one ends the program.
    std::printf("%s\n", file.c_str());
    std::fflush(stdout);
    const std::string bytes = fuzz::Bytes(file);
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }
  std::printf("%zu inputs\n", files.size());
  return files.empty() ? 1 : 0;
}
