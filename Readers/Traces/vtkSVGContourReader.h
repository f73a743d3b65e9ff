// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkSVGContourReader
 * @brief Reads outlines of drawings (.svg), a drawing or a layer a slice.
 *
 * Slice n (from 0) lies at n times SliceSpacing. See SVGParser.h.
 */
#ifndef vtkSVGContourReader_h
#define vtkSVGContourReader_h

#include "vtkTracedObjectsReader.h"

class TRACEREADERS_EXPORT vtkSVGContourReader : public vtkTracedObjectsReader
{
public:
  static vtkSVGContourReader* New();
  vtkTypeMacro(vtkSVGContourReader, vtkTracedObjectsReader);

  /// Whether it is a drawing (.svg).
  static int CanReadFile(const char* fileName);

protected:
  vtkSVGContourReader() = default;
  ~vtkSVGContourReader() override = default;

  recon::TracedFile ReadObjects(
    const std::vector<std::string>& fileNames, recon::Monitor& monitor) override;
  const char* GetKind() override { return "a drawing (.svg)"; }

private:
  vtkSVGContourReader(const vtkSVGContourReader&) = delete;
  void operator=(const vtkSVGContourReader&) = delete;
};

#endif
