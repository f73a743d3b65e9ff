// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file RunCore.h
 * @brief The one way in which a filter, reader or writer lets the core work.
 *
 * What ends here: exceptions, which would end ParaView; the user's wish to stop; inputs with
 * nothing in them. Whatever happens, the answer to VTK is 1 with outputs that are whole or empty,
 * as an answer of 0 makes VTK add a line of its own that says nothing ("Algorithm ... returned
 * failure"), and keeps the other blocks of a collection from being worked on.
 */
#ifndef RunCore_h
#define RunCore_h

#include "ContourFiltersModule.h" // for export macro

#include "vtkErrorCode.h"

#include <functional>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkPolyData;

namespace recon
{
/// Thrown by work that has nothing to do for this input, which is no error; what() is a line for
/// Report.
class NothingLeft : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

using Outputs = std::initializer_list<vtkDataObject*>;

/// What most filters need, as RunCore says it.
constexpr const char* NeedsContours = "contours as poly data: connect a contour reader or Slice";

/**
 * Does the work, and returns 1.
 *
 * Without an input, and where the work throws, there is one error and outputs are empty; they are
 * also empty where the user stopped it. Inputs with nothing in them (no points and no cells, open
 * lines only, what a structure set calls points) are common among the regions of a structure set,
 * and must not stop the others: the outputs are empty, and say so in `Report`.
 *
 * @param input nullptr where none is connected
 * @param needs for the sentence: "contours as poly data: connect a contour reader or Slice"
 */
CONTOURFILTERS_EXPORT int RunCore(vtkAlgorithm* filter, vtkDataObject* input, const char* needs,
  Outputs outputs, const std::function<void()>& work);

/**
 * What a region of a structure set is, of which nothing can be made: "points only, without a
 * contour" (a marker, an isocentre) or "open contours only" (a channel, a wire); empty otherwise.
 * Vertices and open lines of other origin stay an error of whoever wants contours, and a line that
 * ends where it begins is closed, whatever its type.
 */
[[nodiscard]] CONTOURFILTERS_EXPORT std::string NothingOf(vtkPolyData* input);

/// RunCore for any input: also one with nothing in it is worked on.
CONTOURFILTERS_EXPORT int RunOnAnything(
  vtkAlgorithm* filter, Outputs outputs, const std::function<void()>& work);

/// How the work of a reader or writer on its file ended.
struct FileOutcome
{
  unsigned long ErrorCode = vtkErrorCode::NoError;
  std::string Sentence; ///< the error's; empty where all went well or the user stopped it
  bool IsWhole() const { return this->ErrorCode == vtkErrorCode::NoError; }
};

/**
 * For a reader that reads before it may say what is wrong.
 *
 * @param kind of file, for the sentence where no name is set: "a NUAGES file (.cnt)"
 * @param failure error code where the work throws
 */
[[nodiscard]] CONTOURFILTERS_EXPORT FileOutcome TryFile(
  const char* fileName, const char* kind, unsigned long failure, const std::function<void()>& work);

/**
 * RunOnAnything for a reader or a writer, which has a file instead of an input; parameters are those
 * of TryFile.
 *
 * @return the error code, for SetErrorCode
 */
CONTOURFILTERS_EXPORT unsigned long RunOnFile(vtkAlgorithm* algorithm, const char* fileName,
  const char* kind, unsigned long failure, Outputs outputs, const std::function<void()>& work);

/// Whether the file is there and has one of these extensions (".cnt"), in any case. A reader takes
/// such files whatever is in them, so that its sentence says what is wrong, not a list of readers.
CONTOURFILTERS_EXPORT bool HasExtension(
  const char* fileName, std::initializer_list<const char*> extensions);

/**
 * The field data of the input goes along (name, number and colour of a region of interest), but for
 * arrays that the output has of its own, and `Report` becomes these lines.
 */
CONTOURFILTERS_EXPORT void FinishOutput(
  vtkDataObject* input, const std::vector<std::string>& report, vtkDataObject* output);
}

#endif
