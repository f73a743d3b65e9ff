// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkContourAlgorithm
 * @brief What every reader and filter of this project has in common: it says what it did.
 *
 * The field data array `Report` of an output has a line for all that was changed or left out. As it
 * is far from a user's eyes there, GetReport() gives it as text, which ParaView's panel shows after
 * Apply.
 *
 * Inputs beside the first (planes, tables) are asked for whole in every piece. Readers are asked for
 * pieces, of which those of one object leave all but the first empty.
 */
#ifndef vtkContourAlgorithm_h
#define vtkContourAlgorithm_h

#include "ContourFiltersModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for std::string

class CONTOURFILTERS_EXPORT vtkContourAlgorithm : public vtkPolyDataAlgorithm
{
public:
  static vtkContourAlgorithm* New();
  vtkTypeMacro(vtkContourAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * `Report` of the last output, of all blocks where it is a collection: a summary, then a line
   * each, behind the block's name. Empty before the first execution.
   */
  const char* GetReport();

  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /// The same for any other algorithm.
  static std::string ReportOf(vtkAlgorithm* algorithm);

protected:
  vtkContourAlgorithm() = default;
  ~vtkContourAlgorithm() override = default;

private:
  vtkContourAlgorithm(const vtkContourAlgorithm&) = delete;
  void operator=(const vtkContourAlgorithm&) = delete;

  std::string ReportText; // what GetReport gave out last
};

#endif
