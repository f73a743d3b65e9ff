// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file DICOMCharacterSet.h
 * @brief Texts of a DICOM file in UTF-8: its Specific Character Set (0008,0005), with the escape
 * sequences by which one text may hold several (PS3.3 C.12.1.1.2, PS3.5 6.1.2.4 and 6.1.2.5).
 *
 * Notation of ISO 2022: bytes below 80 hex are characters of the set G0, the others of the set G1.
 * An escape sequence puts another set in one of these places; a control character, and in a text
 * of several values the backslash between them, puts back those of the beginning.
 *
 * The tables are those of the C library (iconv), which knows each set but not DICOM's way to mix
 * them; DCMTK refuses most of the mixed ones with it.
 */
#ifndef recon_DICOMCharacterSet_h
#define recon_DICOMCharacterSet_h

#include <string>
#include <string_view>

namespace recon
{
struct DecodedText
{
  enum class How
  {
    Explained, ///< every byte is a character of the sets that the file names
    Guessed,   ///< it is UTF-8, which the file does not say
    Unknown    ///< bytes that nothing explains are '?'
  };
  std::string Text; ///< UTF-8
  How Outcome = How::Explained;
};

class DICOMCharacterSet
{
public:
  /// @param terms the value of Specific Character Set: "ISO_IR 100", "\ISO 2022 IR 87", empty for
  /// ASCII. Terms that the standard does not know are passed over.
  explicit DICOMCharacterSet(const std::string& terms);

  /// @param isPersonName whether '^' and '=' part the text, as in names of persons
  DecodedText Decode(std::string_view text, bool isPersonName = false) const;

private:
  struct Repertoire;
  class Decoder;

  const char* Whole = nullptr;           ///< encoding of texts that have no escape sequences
  const Repertoire* InitialG0 = nullptr; ///< nullptr for ASCII
  const Repertoire* InitialG1 = nullptr; ///< nullptr for none
};
}

#endif
