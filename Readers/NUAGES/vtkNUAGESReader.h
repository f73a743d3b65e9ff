// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkNUAGESReader
 * @brief Reads contours on parallel slices from a NUAGES file (.cnt).
 *
 * The output has a closed polyline a contour, in the order of the file: its last point id repeats
 * the first. Coordinates are those of the file, in double precision; slices lie perpendicular to z.
 * Which contour is an outer wall and which a hole is not decided here: files disagree about the
 * orientation, so that vtkContourHierarchy derives it from the nesting.
 *
 * Field data `Report` (strings) lists what was left out: contours without any vertex.
 *
 * A file that is not whole (truncated, counts that do not add up, text that is no number) gives one
 * error that names file and line, and an empty output.
 *
 * @sa vtkNUAGESWriter
 */
#ifndef vtkNUAGESReader_h
#define vtkNUAGESReader_h

#include "NUAGESReadersModule.h" // for the export macro
#include "vtkContourAlgorithm.h"

class NUAGESREADERS_EXPORT vtkNUAGESReader : public vtkContourAlgorithm
{
public:
  static vtkNUAGESReader* New();
  vtkTypeMacro(vtkNUAGESReader, vtkContourAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Whether the file begins as a NUAGES file does, whatever its name, or its
   * extension says that it should: then the reader tells what is wrong with it.
   */
  static int CanReadFile(const char* fileName);

protected:
  vtkNUAGESReader();
  ~vtkNUAGESReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkNUAGESReader(const vtkNUAGESReader&) = delete;
  void operator=(const vtkNUAGESReader&) = delete;

  char* FileName = nullptr;
};

#endif
