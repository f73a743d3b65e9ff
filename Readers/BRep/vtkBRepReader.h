// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkBRepReader
 * @brief Reads surfaces and their contours from a boundary representation (.brep).
 *
 * The format is that of the thesis's appendix ("BRep file grammar"): shell sets, shells, vertices,
 * half-edges, faces with the partners of their half-edges, contours, and `#` comments anywhere.
 *
 * The output has a triangle a face, shell after shell, and a closed polyline a contour, whose last
 * point id is its first; contours use the points of the surface that they run along. Points are
 * those of the file, in double precision and in its units; no two shells share one. Cell arrays on
 * triangles and polylines alike: `ShellId` (int, counted over the whole file from 0) and `ShellSet`
 * (int, from 0). vtkBRepWriter writes such an output back as it was.
 *
 * Half-edges and partners are not in the output, because the triangles tell them; that they do is
 * checked. A file that does not follow the grammar gives one error that names line and token, one
 * whose topology does not hold together (a partner that is none, a face or a contour that does not
 * close) an error that names shell and half-edge; the output is empty then.
 *
 * @sa vtkBRepWriter
 */
#ifndef vtkBRepReader_h
#define vtkBRepReader_h

#include "BRepReadersModule.h" // for the export macro
#include "vtkContourAlgorithm.h"

class BREPREADERS_EXPORT vtkBRepReader : public vtkContourAlgorithm
{
public:
  static vtkBRepReader* New();
  vtkTypeMacro(vtkBRepReader, vtkContourAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Whether the first word of the file, comments aside, is NUM_SHELL_SETS, whatever its name, or its
   * extension says that it should: then the reader tells what is wrong with it.
   */
  static int CanReadFile(const char* fileName);

protected:
  vtkBRepReader();
  ~vtkBRepReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkBRepReader(const vtkBRepReader&) = delete;
  void operator=(const vtkBRepReader&) = delete;

  char* FileName = nullptr;
};

#endif
