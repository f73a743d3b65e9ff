// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file FuzzTarget.h
 * @brief What a fuzz target is: bytes come in, and a sentence or a sound result goes out.
 *
 * A source Fuzz*.cxx defines Try. libFuzzer calls it with what it makes up (CONTOUR_FUZZ); without libFuzzer,
 * ReplayInputs.cxx calls it with the files of a folder, as an ordinary test. So what is found is kept by the code
 * that found it.
 */
#ifndef FuzzTarget_h
#define FuzzTarget_h

#include "Base/Monitor.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace fuzz
{
/// One input. An Error is an answer as good as any; all else that it throws is a finding.
void Try(const std::string& bytes);

/// Ends the program with these words, which is a finding, unless it holds.
void Require(bool holds, const std::string& words);
/// The same for tests that say what is wrong in words.
inline void RequireNone(const std::string& fault)
{
  Require(fault.empty(), fault);
}

/// A name in a folder of this process, which is gone when it ends.
std::string Name(const std::string& name);
/// A file of these bytes there; its name.
std::string File(const std::string& bytes, const std::string& name = "input");
std::string Bytes(const std::string& fileName);
}

/// libFuzzer's entry.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

#endif
