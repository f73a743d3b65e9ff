// SPDX-License-Identifier: GPL-3.0-or-later
// A worker of `./run bench collection`: a case a line of standard input, an answer each on standard output.
//
//   bench_collection               cases; an answer is a line of words with tabs between, and the mesh in binary
//   bench_collection --list FILE   the regions of a file of contours
#include "CollectionVerdict.h"

#include <cstdint>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

using namespace recon;
using namespace recon::collection;

namespace
{
std::vector<std::string> WordsOf(const std::string& line)
{
  std::vector<std::string> words;
  std::size_t from = 0;
  for (std::size_t to = line.find('\t'); to != std::string::npos; to = line.find('\t', from))
  {
    words.push_back(line.substr(from, to - from));
    from = to + 1;
  }
  words.push_back(line.substr(from));
  return words;
}

void Write(const Verdict& verdict)
{
  std::printf("%s\t%.6f\t%zu\t%zu\t%zu\t%zu\t%.17g\t%.17g\t%.17g\t%.6g\t%s\n", NameOf(verdict.Kind),
    verdict.Seconds, verdict.Points, verdict.Levels, verdict.Mesh.Points.size(),
    verdict.Mesh.Triangles.size(), verdict.Volume, verdict.Area, verdict.Diagonal, verdict.Off,
    verdict.Reason.c_str());
  std::fwrite(verdict.Mesh.Points.data(), sizeof(Point3), verdict.Mesh.Points.size(), stdout);
  std::fwrite(verdict.Mesh.Triangles.data(), sizeof(verdict.Mesh.Triangles[0]),
    verdict.Mesh.Triangles.size(), stdout);
  std::fflush(stdout);
}

int List(const std::string& fileName)
{
  for (const std::string& name : RegionsOf(fileName))
  {
    std::printf("%s\n", name.c_str());
  }
  return 0;
}

int Answer()
{
  std::string line;
  while (std::getline(std::cin, line))
  {
    Verdict verdict;
    try
    {
      verdict = Judge(MakeCase(WordsOf(line)));
    }
    catch (const Error& error)
    {
      verdict.Kind = Verdict::Refused;
      verdict.Reason = error.what();
    }
    Write(verdict);
  }
  return 0;
}
}

int main(int argc, char** argv)
{
  try
  {
    const std::string option = argc > 1 ? argv[1] : "";
    if (argc == 3 && option == "--list")
    {
      return List(argv[2]);
    }
    return argc == 1 ? Answer() : 2;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "bench_collection: %s\n", error.what());
    return 1;
  }
}
