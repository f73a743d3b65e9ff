// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkContourTableReader
 * @brief Reads contours from a table of points (.csv, .tsv, .txt).
 *
 * A row a point, with columns x, y and z or slice, and optionally contour and object. See
 * ContourTableParser.h.
 */
#ifndef vtkContourTableReader_h
#define vtkContourTableReader_h

#include "vtkTracedObjectsReader.h"

class TRACEREADERS_EXPORT vtkContourTableReader : public vtkTracedObjectsReader
{
public:
  static vtkContourTableReader* New();
  vtkTypeMacro(vtkContourTableReader, vtkTracedObjectsReader);

  /// Whether it is a table of points (.csv, .tsv, .txt).
  static int CanReadFile(const char* fileName);

protected:
  vtkContourTableReader() = default;
  ~vtkContourTableReader() override = default;

  recon::TracedFile ReadObjects(
    const std::vector<std::string>& fileNames, recon::Monitor& monitor) override;
  const char* GetKind() override { return "a table of points (.csv, .tsv, .txt)"; }

private:
  vtkContourTableReader(const vtkContourTableReader&) = delete;
  void operator=(const vtkContourTableReader&) = delete;
};

#endif
