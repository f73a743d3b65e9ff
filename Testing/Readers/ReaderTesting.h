// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ReaderTesting.h
 * @brief What the tests of the parsers share: files to try, files of others, and the sentence of an
 * error.
 */
#ifndef ReaderTesting_h
#define ReaderTesting_h

#include "Base/Monitor.h"
#include "Contours/ContourSet.h"
#include "TestPaths.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <string>

namespace readertesting
{
/// A folder of its own a test, with a space in its name; gone at the end.
class Folder : public testing::Test
{
protected:
  Folder()
  {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    this->Path = std::filesystem::temp_directory_path() /
      ("contour readers " + std::string(info->test_suite_name()) + info->name() + " " +
        std::to_string(std::random_device()()));
    std::filesystem::create_directories(this->Path);
  }
  ~Folder() override
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->Path, ignored);
  }

  std::string Name(const std::string& name) const { return (this->Path / name).string(); }

  std::string Write(const std::string& name, const std::string& bytes) const
  {
    std::ofstream file(this->Name(name), std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return this->Name(name);
  }

private:
  std::filesystem::path Path;
};

inline std::string Bytes(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

inline std::string RandomBytes(std::size_t count, unsigned int seed)
{
  std::mt19937 random(seed);
  std::string bytes(count, '\0');
  for (char& byte : bytes)
  {
    byte = static_cast<char>(random() & 0xff);
  }
  return bytes;
}

/// A file of the shared data; empty where it is absent, so that the test can skip.
inline std::string Shared(const std::string& name)
{
  const std::string full = recon::testing::SharedPath(name);
  return std::filesystem::exists(full) ? full : std::string();
}

/// The sentence of the error that action ends in; empty where it ends in none. Anything but
/// recon::Error passes through and fails the test.
inline std::string SentenceOf(const std::function<void()>& action)
{
  try
  {
    action();
  }
  catch (const recon::Error& error)
  {
    return error.what();
  }
  return {};
}

/// One sentence, in one line, that names the file and has this in it.
inline void ExpectSentence(
  const std::string& sentence, const std::string& fileName, const std::string& part)
{
  EXPECT_NE(sentence.find(part), std::string::npos)
    << "expected \"" << part << "\" in: " << sentence;
  EXPECT_NE(sentence.find(fileName), std::string::npos) << sentence;
  EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
  EXPECT_TRUE(!sentence.empty() && sentence.back() == '.') << sentence;
}

/// Points, chains and closedness to the last bit.
inline bool Equal(const recon::LoopSoup& a, const recon::LoopSoup& b)
{
  if (a.Points != b.Points || a.Chains.size() != b.Chains.size())
  {
    return false;
  }
  for (std::size_t i = 0; i < a.Chains.size(); ++i)
  {
    if (a.Chains[i].Points != b.Chains[i].Points || a.Chains[i].Closed != b.Chains[i].Closed)
    {
      return false;
    }
  }
  return true;
}
}

#define CONTOUR_SKIP_UNLESS(name) \
  if ((name).empty())             \
  GTEST_SKIP() << "the shared data is not there; set CONTOUR_SHARED_DATA"

#endif
