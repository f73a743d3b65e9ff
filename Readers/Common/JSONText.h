// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file JSONText.h
 * @brief A JSON text (RFC 8259) as a value, with errors that name file and line.
 */
#ifndef recon_JSONText_h
#define recon_JSONText_h

#include "Base/Monitor.h"

#include <string>
#include <utility>
#include <vector>

namespace recon
{
/// A list of numbers alone is in Numbers, so that long ones take eight bytes a number.
struct JSONValue
{
  enum class Kind
  {
    Null,
    Boolean,
    Number,
    String,
    List,
    Object
  };
  Kind Type = Kind::Null;
  bool Boolean = false;
  double Number = 0;
  std::string String;                                   ///< UTF-8
  std::vector<JSONValue> Items;                         ///< of a list
  std::vector<double> Numbers;                          ///< of a list that is numbers alone
  std::vector<std::pair<std::string, JSONValue>> Pairs; ///< of an object, in the file's order

  bool IsObject() const { return this->Type == Kind::Object; }
  bool IsString() const { return this->Type == Kind::String; }
  bool IsNumber() const { return this->Type == Kind::Number; }
  /// Of an object; nullptr where it has none of that name.
  const JSONValue* Find(const std::string& name) const;
};

/// @throws Error where the text is no JSON, or nested more than 64 deep.
JSONValue ReadJSON(const std::string& fileName, const std::string& text, Monitor& monitor);
}

#endif
