// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkTracedObjectsReader
 * @brief What the readers of tracing programs have in common: a block an object, and a choice of
 * them.
 *
 * Blocks are named after their objects, and have
 * - closed polylines, polylines where a trace is open, vertices where it is a point, in double precision;
 * - cell arrays `GeometricType` (CLOSED_PLANAR, OPEN_PLANAR or POINT, as in DICOM), `Slice` (its number in
 *   the file) and, where traces have names of their own, `Name`;
 * - field data `ROIName`, `ROINumber` (from 1), `ROIColor` where the file gives one, `LengthUnit` (empty where it
 *   tells none), as the RT structure set reader gives them.
 *
 * The field data of the collection has a `Report` of everything odd.
 */
#ifndef vtkTracedObjectsReader_h
#define vtkTracedObjectsReader_h

#include "TraceReadersModule.h" // for the export macro
#include "vtkNew.h"             // for vtkNew
#include "vtkPartitionedDataSetCollectionAlgorithm.h"

#include <memory> // for std::unique_ptr
#include <string> // for std::string
#include <vector> // for std::vector

class vtkDataArraySelection;

namespace recon
{
class Monitor;
struct Piece;
struct TracedFile;
}

class TRACEREADERS_EXPORT vtkTracedObjectsReader : public vtkPartitionedDataSetCollectionAlgorithm
{
public:
  vtkTypeMacro(vtkTracedObjectsReader, vtkPartitionedDataSetCollectionAlgorithm);
  static vtkTracedObjectsReader* New();
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read, or, of drawings, a file a slice.
   */
  void SetFileName(const char* fileName);
  const char* GetFileName();
  void AddFileName(const char* fileName);
  void RemoveAllFileNames();
  ///@}

  ///@{
  /**
   * For formats that do not tell where slices lie: their distance, negative where they follow towards
   * -z, and what one unit of the drawing is. Default: 1.
   */
  vtkSetMacro(SliceSpacing, double);
  vtkGetMacro(SliceSpacing, double);
  vtkSetMacro(PixelSize, double);
  vtkGetMacro(PixelSize, double);
  ///@}

  /**
   * The objects by name, and whether each is wanted: all are, to begin with. UpdateInformation
   * fills it.
   */
  vtkDataArraySelection* GetObjectSelection();

  vtkMTimeType GetMTime() override;

  /// See vtkContourAlgorithm.
  const char* GetReport();
  /// Of the last attempt to read, as vtkErrorCode has it.
  unsigned long GetErrorCode() { return this->ErrorCode; }

protected:
  vtkTracedObjectsReader();
  ~vtkTracedObjectsReader() override;

  /// Of the base class: no format.
  virtual recon::TracedFile ReadObjects(
    const std::vector<std::string>& fileNames, recon::Monitor& monitor);
  /// For the sentence where no name is set: "an IMOD model (.mod)".
  virtual const char* GetKind() { return "a file of a tracing program"; }

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double SliceSpacing = 1;
  double PixelSize = 1;

private:
  vtkTracedObjectsReader(const vtkTracedObjectsReader&) = delete;
  void operator=(const vtkTracedObjectsReader&) = delete;

  recon::TracedFile TakeListed();
  void FillOutput(const recon::TracedFile& file, recon::Piece piece, vtkDataObject* output);

  std::vector<std::string> FileNames;
  vtkNew<vtkDataArraySelection> ObjectSelection;
  std::unique_ptr<recon::TracedFile>
    Listed; // what RequestInformation read, for the RequestData behind it
  std::string ReportText;
  unsigned long ErrorCode = 0;
};

#endif
