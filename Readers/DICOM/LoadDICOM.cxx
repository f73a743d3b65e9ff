// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/LoadDICOM.h"

#include "Base/Monitor.h"

#include <dcmtk/dcmdata/dcdict.h>
#include <dcmtk/dcmdata/dcistrmf.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>

namespace recon
{
namespace
{
/// Where the stack is, whatever sanitizers do with variables.
std::uintptr_t PlaceOnStack()
{
#if defined(__GNUC__)
  return reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0));
#else
  const volatile char here = 0;
  return reinterpret_cast<std::uintptr_t>(&here);
#endif
}

/// A value that is longer than all that can be there: it is left where it is, and never had.
class NoValue : public DcmInputStreamFactory
{
public:
  DcmInputStream* create() const override { return nullptr; }
  DcmInputStreamFactory* clone() const override { return new NoValue; }
  DcmInputStreamFactoryType ident() const override { return DFT_DcmInputFileStreamFactory; }
};

/// Comes to an end where a limit is passed: each level of recursion asks its stream before the next.
class LimitedFile : public DcmInputFileStream
{
public:
  LimitedFile(const std::string& fileName, std::size_t size)
    : DcmInputFileStream(fileName.c_str()),
      Start(PlaceOnStack()),
      End(static_cast<offile_off_t>(MostInflationOfDICOM * std::max(size, SmallestSize)))
  {
  }

  OFBool good() const override { return this->Why.empty() && DcmInputFileStream::good(); }
  OFCondition status() const override
  {
    return this->Why.empty() ? DcmInputFileStream::status() : OFCondition(EC_CorruptedData);
  }
  offile_off_t read(void* buffer, offile_off_t length) override
  {
    return this->IsWithinLimits()
      ? DcmInputFileStream::read(buffer, std::min(length, this->GetLeft()))
      : 0;
  }
  offile_off_t skip(offile_off_t length) override
  {
    if (!this->IsWithinLimits())
    {
      return 0;
    }
    const offile_off_t skipped = DcmInputFileStream::skip(std::min(length, this->GetLeft()));
    this->IsWithinLimits(); // nobody may ask again
    return skipped;
  }
  /// DCMTK asks for one where a value is longer than GetLongestValue. Without, as of a deflated data set, it would
  /// take memory of that length, which is only announced.
  DcmInputStreamFactory* newFactory() const override { return new NoValue; }
  OFBool eos() override { return !this->IsWithinLimits() || DcmInputFileStream::eos(); }

  /// No value that is there is longer.
  Uint32 GetLongestValue() const
  {
    constexpr offile_off_t most = DCM_UndefinedLength - 1;
    return static_cast<Uint32>(std::min(this->End, most));
  }

  /// Which limit was passed; empty where none was.
  const std::string& GetWhy() const { return this->Why; }

private:
  /// What is smaller than a page unpacks to nothing large.
  static constexpr std::size_t SmallestSize = 4096;

  offile_off_t GetLeft() const { return this->End + 1 - this->tell(); }

  bool IsWithinLimits()
  {
    const std::uintptr_t here = PlaceOnStack();
    if (std::max(here, this->Start) - std::min(here, this->Start) > MostStackOfDICOM)
    {
      this->Why = "its sequences are nested deeper than those of any DICOM object; it is damaged, "
                  "or made to do harm.";
    }
    else if (this->tell() > this->End)
    {
      this->Why = "it is deflated, and unpacks to more than " +
        std::to_string(MostInflationOfDICOM) +
        " times its size; it is damaged, or made to do harm.";
    }
    return this->Why.empty();
  }

  const std::uintptr_t Start;
  const offile_off_t End;
  std::string Why;
};
}

std::string LoadDICOMUntil(
  const std::string& fileName, DcmFileFormat& file, const DcmTagKey& element)
{
  std::error_code status;
  if (!std::filesystem::is_regular_file(fileName, status))
  {
    return "there is no such file.";
  }
  const auto size = std::filesystem::file_size(fileName, status);
  if (status || size == 0)
  {
    return "the file is empty.";
  }
  if (!dcmDataDict.isDictionaryLoaded())
  {
    return "DCMTK has no data dictionary; install DCMTK's dicom.dic or set DCMDICTPATH to it.";
  }
  LimitedFile stream(fileName, static_cast<std::size_t>(size));
  OFCondition condition = stream.status();
  if (condition.good())
  {
    file.clear();
    file.transferInit();
    // All values at once: those that DCMTK leaves in the file it would later look for in whatever has that name then.
    condition =
      file.readUntilTag(stream, EXS_Unknown, EGL_noChange, stream.GetLongestValue(), element);
    file.transferEnd();
  }
  if (!stream.GetWhy().empty())
  {
    return stream.GetWhy();
  }
  return condition.good() ? std::string()
                          : "it is no DICOM file or is damaged or truncated (DCMTK says: " +
      std::string(condition.text()) + ").";
}

void LoadDICOM(const std::string& fileName, DcmFileFormat& file)
{
  const std::string why = LoadDICOMUntil(fileName, file, DCM_PixelData);
  if (!why.empty())
  {
    throw Error("Cannot read " + fileName + ": " + why);
  }
}
}
