// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file FileOutcome.h
 * @brief How the work of a VTK reader or writer on its file ended, which all of them tell alike.
 */
#ifndef recon_FileOutcome_h
#define recon_FileOutcome_h

#include "Base/Monitor.h"

#include "vtkErrorCode.h"

#include <exception>
#include <string>

namespace recon
{
struct FileOutcome
{
  unsigned long ErrorCode = vtkErrorCode::NoError;
  std::string Sentence; ///< for vtkErrorMacro; empty where all went well or the user stopped it
  bool IsWhole() const { return this->ErrorCode == vtkErrorCode::NoError; }
};

/**
 * Does the work; no exception leaves it, as one that leaves RequestData ends ParaView.
 *
 * @param kind of file, for the sentence where no name is set: "a NUAGES file (.cnt)"
 * @param failure error code where the work throws
 */
template <typename Work>
FileOutcome TryFile(const char* fileName, const char* kind, unsigned long failure, Work work)
{
  if (!fileName || !*fileName)
  {
    return { vtkErrorCode::NoFileNameError,
      std::string("No file name is set: set FileName to ") + kind + "." };
  }
  try
  {
    work();
    return {};
  }
  catch (const Aborted&)
  {
    return { vtkErrorCode::UserError, {} };
  }
  catch (const std::exception& error)
  {
    return { failure, error.what() };
  }
}
}

#endif
