// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkContourTableWriter
 * @brief Writes contours as a table of points (.csv) that spreadsheets and vtkContourTableReader read.
 *
 * Input is a vtkPolyData, or a collection with a block an object. Columns are object, slice (the cell array
 * `Slice`, where all blocks have it), contour, x, y and z; see ContourTableFormatter.h. Loose segments and
 * open polylines (what ParaView's Slice gives) are chained to closed contours first; of blocks with
 * a cell array `GeometricType`, whose lines are whole, open ones and points are left out with a warning.
 *
 * @sa vtkContourTableReader
 */
#ifndef vtkContourTableWriter_h
#define vtkContourTableWriter_h

#include "TraceReadersModule.h" // for the export macro
#include "vtkContourWriter.h"

class TRACEREADERS_EXPORT vtkContourTableWriter : public vtkContourWriter
{
public:
  static vtkContourTableWriter* New();
  vtkTypeMacro(vtkContourTableWriter, vtkContourWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to write; one that is there is replaced.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkContourTableWriter();
  ~vtkContourTableWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  const char* GetTarget() override { return this->FileName; }
  const char* GetTargetKind() override { return "the table to write (.csv)"; }
  void WriteWhole() override;

private:
  vtkContourTableWriter(const vtkContourTableWriter&) = delete;
  void operator=(const vtkContourTableWriter&) = delete;

  char* FileName = nullptr;
};

#endif
