// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/DICOMCharacterSet.h"

#include "DICOM/DICOMText.h"

#include <array>
#include <cctype>
#include <map>
#include <vector>

#include <iconv.h>

namespace recon
{
/// A set of characters that escape sequences can put in place, as the C library knows it.
struct DICOMCharacterSet::Repertoire
{
  const char* Escape;   ///< behind the escape character
  int Registration;     ///< of ISO: 87 of "ISO 2022 IR 87"; 0 where no term names it
  bool IsG1;            ///< in place of bytes from 80 hex on, else in place of those below
  std::size_t Bytes;    ///< of a character
  const char* Encoding; ///< of the C library, which has this set among others
  const char* Before;   ///< bytes that a character has before it in that encoding
  unsigned char Upper;  ///< bits that its bytes have on there
};

namespace
{
constexpr char EscapeCharacter = '\x1b';

/// A converter of the C library.
class Converter
{
public:
  explicit Converter(const char* from) : Descriptor(iconv_open("UTF-8", from)) {}
  ~Converter()
  {
    if (this->IsOpen())
    {
      iconv_close(this->Descriptor);
    }
  }
  Converter(const Converter&) = delete;
  Converter& operator=(const Converter&) = delete;

  /// Appends the text; whether it is one, which some C libraries know all sets for and some do not.
  bool Append(std::string_view text, std::string& utf8)
  {
    if (!this->IsOpen())
    {
      return false;
    }
    std::string from(text);
    // The longest: three bytes of UTF-8 of one.
    std::string to(4 * from.size() + 4, '\0');
    char* source = from.data();
    char* target = to.data();
    std::size_t left = from.size();
    std::size_t room = to.size();
    iconv(this->Descriptor, nullptr, nullptr, nullptr, nullptr);
    if (iconv(this->Descriptor, &source, &left, &target, &room) == static_cast<std::size_t>(-1))
    {
      return false;
    }
    utf8.append(to, 0, to.size() - room);
    return true;
  }

private:
  bool IsOpen() const { return this->Descriptor != reinterpret_cast<iconv_t>(-1); }

  iconv_t Descriptor;
};

std::vector<std::string> TermsOf(const std::string& value)
{
  std::vector<std::string> terms(1);
  for (const char c : value)
  {
    if (c == '\\')
    {
      terms.emplace_back();
    }
    else if (std::isalnum(static_cast<unsigned char>(c)))
    {
      terms.back() += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
  }
  return terms;
}

/// 87 of "ISO2022IR87", 100 of "ISOIR100"; -1 of anything else.
int RegistrationOf(const std::string& term)
{
  const std::size_t at = term.rfind("IR");
  if (at == std::string::npos || at + 2 == term.size() || term.size() > at + 6)
  {
    return -1;
  }
  int number = 0;
  for (std::size_t i = at + 2; i < term.size(); ++i)
  {
    if (term[i] < '0' || term[i] > '9')
    {
      return -1;
    }
    number = 10 * number + (term[i] - '0');
  }
  return number;
}
}

/// One text on its way to UTF-8.
class DICOMCharacterSet::Decoder
{
public:
  Decoder(const DICOMCharacterSet& set, bool isPersonName)
    : Set(set),
      IsPersonName(isPersonName),
      G0(set.InitialG0),
      G1(set.InitialG1)
  {
  }

  static const std::array<Repertoire, 20>& Repertoires();
  static const Repertoire* Find(int registration, bool isG1);

  DecodedText Decode(std::string_view text);

private:
  /// Takes an escape sequence off the text; whether one is known.
  bool TakeEscape(std::string_view& text);
  /// Takes a character off the text.
  void TakeCharacter(std::string_view& text);
  bool EndsText(char c) const
  {
    return (c > 0 && c < ' ') || c == '\\' || (this->IsPersonName && (c == '^' || c == '='));
  }
  Converter& ConverterOf(const char* encoding);
  void TakeUnknown(std::string_view& text)
  {
    text.remove_prefix(1);
    this->Result.Text += '?';
    this->Result.Outcome = DecodedText::How::Unknown;
  }

  const DICOMCharacterSet& Set;
  const bool IsPersonName;
  const Repertoire* G0;
  const Repertoire* G1;
  std::map<std::string, Converter> Converters;
  DecodedText Result;
};

const std::array<DICOMCharacterSet::Repertoire, 20>& DICOMCharacterSet::Decoder::Repertoires()
{
  // PS3.3 tables C.12-3 and C.12-4. The last two are no part of DICOM and occur all the same: JIS
  // of 1978, which the later one replaced, and katakana as G0.
  static const std::array<Repertoire, 20> repertoires{ {
    { "(B", 6, false, 1, nullptr, "", 0 },
    { "(J", 14, false, 1, "JIS_C6220-1969-RO", "", 0 },
    { "$B", 87, false, 2, "EUC-JP", "", 0x80 },
    { "$(D", 159, false, 2, "EUC-JP", "\x8f", 0x80 },
    { "-A", 100, true, 1, "ISO-8859-1", "", 0 },
    { "-B", 101, true, 1, "ISO-8859-2", "", 0 },
    { "-C", 109, true, 1, "ISO-8859-3", "", 0 },
    { "-D", 110, true, 1, "ISO-8859-4", "", 0 },
    { "-L", 144, true, 1, "ISO-8859-5", "", 0 },
    { "-G", 127, true, 1, "ISO-8859-6", "", 0 },
    { "-F", 126, true, 1, "ISO-8859-7", "", 0 },
    { "-H", 138, true, 1, "ISO-8859-8", "", 0 },
    { "-M", 148, true, 1, "ISO-8859-9", "", 0 },
    { "-b", 203, true, 1, "ISO-8859-15", "", 0 },
    { "-T", 166, true, 1, "TIS-620", "", 0 },
    { ")I", 13, true, 1, "EUC-JP", "\x8e", 0 },
    { "$)C", 149, true, 2, "EUC-KR", "", 0 },
    { "$)A", 58, true, 2, "GB2312", "", 0 },
    { "$@", 0, false, 2, "EUC-JP", "", 0x80 },
    { "(I", 0, false, 1, "EUC-JP", "\x8e", 0x80 },
  } };
  return repertoires;
}

const DICOMCharacterSet::Repertoire* DICOMCharacterSet::Decoder::Find(int registration, bool isG1)
{
  for (const Repertoire& repertoire : Repertoires())
  {
    if (repertoire.Registration == registration && repertoire.IsG1 == isG1)
    {
      return &repertoire;
    }
  }
  return nullptr;
}

Converter& DICOMCharacterSet::Decoder::ConverterOf(const char* encoding)
{
  return this->Converters.try_emplace(encoding, encoding).first->second;
}

bool DICOMCharacterSet::Decoder::TakeEscape(std::string_view& text)
{
  for (const Repertoire& repertoire : Repertoires())
  {
    const std::string_view escape(repertoire.Escape);
    if (text.substr(1, escape.size()) == escape)
    {
      (repertoire.IsG1 ? this->G1 : this->G0) = &repertoire;
      text.remove_prefix(1 + escape.size());
      return true;
    }
  }
  return false;
}

void DICOMCharacterSet::Decoder::TakeCharacter(std::string_view& text)
{
  const bool isG1 = static_cast<unsigned char>(text[0]) >= 0x80;
  const Repertoire* repertoire = isG1 ? this->G1 : this->G0;
  if (!isG1 && (text[0] == ' ' || !repertoire || !repertoire->Encoding))
  {
    this->Result.Text += text[0];
    text.remove_prefix(1);
    return;
  }
  if (!repertoire || text.size() < repertoire->Bytes)
  {
    this->TakeUnknown(text);
    return;
  }
  std::string bytes(repertoire->Before);
  for (const char c : text.substr(0, repertoire->Bytes))
  {
    bytes += static_cast<char>(static_cast<unsigned char>(c) | repertoire->Upper);
  }
  if (!this->ConverterOf(repertoire->Encoding).Append(bytes, this->Result.Text))
  {
    this->TakeUnknown(text);
    return;
  }
  text.remove_prefix(repertoire->Bytes);
}

DecodedText DICOMCharacterSet::Decoder::Decode(std::string_view text)
{
  while (!text.empty())
  {
    // The second byte of a character of two may be any of these.
    const bool isBetween = !this->G0 || this->G0->Bytes == 1 || text[0] < '!';
    if (text[0] == EscapeCharacter)
    {
      if (!this->TakeEscape(text))
      {
        this->TakeUnknown(text);
      }
    }
    else if (isBetween && this->EndsText(text[0]))
    {
      this->G0 = this->Set.InitialG0;
      this->G1 = this->Set.InitialG1;
      this->Result.Text += text[0];
      text.remove_prefix(1);
    }
    else
    {
      this->TakeCharacter(text);
    }
  }
  return std::move(this->Result);
}

DICOMCharacterSet::DICOMCharacterSet(const std::string& value)
{
  const std::vector<std::string> terms = TermsOf(value);
  const std::map<std::string, const char*> whole{ { "ISOIR192", "UTF-8" }, { "UTF8", "UTF-8" },
    { "GB18030", "GB18030" }, { "GBK", "GBK" } };
  const auto found = whole.find(terms[0]);
  if (found != whole.end())
  {
    this->Whole = found->second;
    return;
  }
  for (std::size_t i = 0; i < terms.size(); ++i)
  {
    const int registration = RegistrationOf(terms[i]);
    // That of the first value holds from the beginning. Sets of the others come by an escape
    // sequence, which writers of one set besides ASCII forget.
    if (!this->InitialG1 && registration > 0)
    {
      this->InitialG1 = Decoder::Find(registration, true);
    }
    if (i == 0 && registration == 13)
    {
      this->InitialG0 = Decoder::Find(14, false);
    }
  }
}

DecodedText DICOMCharacterSet::Decode(std::string_view text, bool isPersonName) const
{
  const bool isPlain = IsASCII(text);
  if (isPlain && text.find(EscapeCharacter) == std::string_view::npos && !this->InitialG0)
  {
    return { std::string(text), DecodedText::How::Explained };
  }
  if (this->Whole)
  {
    DecodedText result;
    if (Converter(this->Whole).Append(text, result.Text))
    {
      return result;
    }
  }
  else
  {
    DecodedText result = Decoder(*this, isPersonName).Decode(text);
    if (result.Outcome == DecodedText::How::Explained)
    {
      return result;
    }
    if (isPlain || !IsUTF8(text))
    {
      return result;
    }
  }
  if (IsUTF8(text))
  {
    return { std::string(text), DecodedText::How::Guessed };
  }
  std::string plain(text);
  for (char& c : plain)
  {
    c = static_cast<unsigned char>(c) < 0x80 ? c : '?';
  }
  return { plain, DecodedText::How::Unknown };
}
}
