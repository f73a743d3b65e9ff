// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/XMLText.h"

#include <expat.h>

#include <algorithm>
#include <exception>
#include <memory>

namespace recon
{
namespace
{
constexpr std::size_t PieceSize = 1 << 16; // bytes between two looks at the user's wish to stop
constexpr char Separator = '|';            // between a namespace and a name, which have none

std::string WithoutNamespace(const char* name)
{
  const std::string full = name;
  const std::size_t end = full.rfind(Separator);
  return end == std::string::npos ? full : full.substr(end + 1);
}

/// Expat is C: exceptions must not pass through it, so that they wait until it has returned.
class Reader
{
public:
  Reader(XMLHandler& handler)
    : Handler(handler),
      Parser(XML_ParserCreateNS(nullptr, Separator), XML_ParserFree)
  {
    XML_SetUserData(this->Parser.get(), this);
    XML_SetElementHandler(this->Parser.get(), Begin, End);
  }

  void Parse(const std::string& fileName, const std::string& text, Monitor& monitor)
  {
    for (std::size_t at = 0; at <= text.size(); at += PieceSize)
    {
      const std::size_t size = std::min(PieceSize, text.size() - at);
      const bool isLast = at + size == text.size();
      const auto status =
        XML_Parse(this->Parser.get(), text.data() + at, static_cast<int>(size), isLast);
      if (this->Thrown)
      {
        std::rethrow_exception(this->Thrown);
      }
      if (status == XML_STATUS_ERROR)
      {
        throw Error("Cannot read " + fileName + ", line " + std::to_string(this->Line()) +
          ": it is no well-formed XML (" + XML_ErrorString(XML_GetErrorCode(this->Parser.get())) +
          ").");
      }
      if (isLast)
      {
        return;
      }
      monitor.Update(static_cast<double>(at) / static_cast<double>(text.size()), "reading");
    }
  }

private:
  int Line() const { return static_cast<int>(XML_GetCurrentLineNumber(this->Parser.get())); }

  template <typename Work>
  void Guarded(const Work& work)
  {
    if (this->Thrown)
    {
      return;
    }
    try
    {
      work();
    }
    catch (...)
    {
      this->Thrown = std::current_exception();
      XML_StopParser(this->Parser.get(), XML_FALSE);
    }
  }

  static void XMLCALL Begin(void* self, const char* name, const char** attributes)
  {
    auto& reader = *static_cast<Reader*>(self);
    reader.Guarded(
      [&]
      {
        XMLElement element;
        element.Name = WithoutNamespace(name);
        element.Line = reader.Line();
        for (; *attributes; attributes += 2)
        {
          element.Attributes.emplace_back(WithoutNamespace(attributes[0]), attributes[1]);
        }
        reader.Handler.Begin(element);
      });
  }

  static void XMLCALL End(void* self, const char* name)
  {
    auto& reader = *static_cast<Reader*>(self);
    reader.Guarded([&] { reader.Handler.End(WithoutNamespace(name)); });
  }

  XMLHandler& Handler;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> Parser;
  std::exception_ptr Thrown;
};
}

const std::string* XMLElement::Find(const char* name) const
{
  const auto found = std::find_if(this->Attributes.begin(), this->Attributes.end(),
    [name](const auto& attribute) { return attribute.first == name; });
  return found == this->Attributes.end() ? nullptr : &found->second;
}

std::string XMLElement::Get(const char* name) const
{
  const std::string* value = this->Find(name);
  return value ? *value : std::string();
}

void ReadXML(
  const std::string& fileName, const std::string& text, XMLHandler& handler, Monitor& monitor)
{
  Reader(handler).Parse(fileName, text, monitor);
}
}
