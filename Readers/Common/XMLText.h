// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file XMLText.h
 * @brief Elements of an XML file one after the other, with errors that name file and line.
 */
#ifndef recon_XMLText_h
#define recon_XMLText_h

#include "Base/Monitor.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace recon
{
/// An element as it begins. Names are without their namespace's prefix.
struct XMLElement
{
  std::string Name;
  std::vector<std::pair<std::string, std::string>> Attributes;
  int Line = 0;

  /// nullptr where it has none of that name.
  const std::string* Find(const char* name) const;
  /// Empty where it has none of that name.
  std::string Get(const char* name) const;
};

/// What is told of a file's elements. What it throws passes through.
class XMLHandler
{
public:
  virtual ~XMLHandler() = default;
  virtual void Begin(const XMLElement& element) = 0;
  virtual void End(const std::string& name) = 0;
};

/**
 * Reads the text of a file. Entities are expanded within Expat's limits only, and nothing is ever
 * fetched that a document refers to.
 *
 * @throws Error with file and line where it is no well-formed XML
 */
void ReadXML(
  const std::string& fileName, const std::string& text, XMLHandler& handler, Monitor& monitor);
}

#endif
