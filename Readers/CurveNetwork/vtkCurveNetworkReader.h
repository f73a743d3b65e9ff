// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkCurveNetworkReader
 * @brief Reads planar cross-sections with materials from .csl and .contour files.
 *
 * The format is told by the content: a cross-section set begins with "CSLC" (.csl), a curve network
 * with the number of its planes (.contour).
 *
 * Where the file has one material, the output is a vtkPolyData; where it has several, a
 * vtkPartitionedDataSetCollection with a block a material, named "Material 1" and so on. Each holds
 * the boundary of its material's region in every plane as closed polylines (last point id = first),
 * so that neighbouring materials have their common boundary each. Coordinates are those of the
 * file, in double precision, in planes of any orientation.
 *
 * Cell array `Plane` (int, from 0 in the order of the file); field data `Material` (int, the label)
 * and, on the output, `Report` (strings): planes that do not fit their vertices, swapped sides,
 * boundaries that do not close, what was left out.
 *
 * Rings of a .csl keep their orientation. Loops of a .contour have their material to the left, seen
 * from the tip of the plane's normal. A file that is not whole gives one error that names file and
 * line, and an empty output.
 */
#ifndef vtkCurveNetworkReader_h
#define vtkCurveNetworkReader_h

#include "CurveNetworkReadersModule.h" // for the export macro
#include "vtkDataObjectAlgorithm.h"

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class CURVENETWORKREADERS_EXPORT vtkCurveNetworkReader : public vtkDataObjectAlgorithm
{
public:
  static vtkCurveNetworkReader* New();
  vtkTypeMacro(vtkCurveNetworkReader, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Whether the file begins as one of the two formats does, whatever its name, or its
   * extension says that it should: then the reader tells what is wrong with it.
   */
  static int CanReadFile(const char* fileName);

  /// See vtkContourAlgorithm.
  const char* GetReport();

protected:
  vtkCurveNetworkReader();
  ~vtkCurveNetworkReader() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkCurveNetworkReader(const vtkCurveNetworkReader&) = delete;
  void operator=(const vtkCurveNetworkReader&) = delete;

  class Internals;

  char* FileName = nullptr;
  std::unique_ptr<Internals> Implementation;
  std::string ReportText; // what GetReport gave out last
};

#endif
