// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file TextFile.h
 * @brief Whole text files, and numbers in them: what the text formats share below their grammars.
 */
#ifndef recon_TextFile_h
#define recon_TextFile_h

#include <string>

namespace recon
{
/// @throws Error where the file does not exist or cannot be read.
std::string ReadTextFile(const std::string& fileName);

/// @throws Error where the file cannot be written; what was there before is then still there.
void WriteTextFile(const std::string& fileName, const std::string& text);

/// The fewest digits (17 at most) that give the same double again, whatever the locale.
void AppendNumber(std::string& text, double value);
}

#endif
