// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkImageJReader
 * @brief Reads ROIs of ImageJ: one (.roi) or a set (.zip).
 *
 * Coordinates are pixels times PixelSize; slice n lies at (n - 1) times SliceSpacing. See
 * ImageJParser.h.
 */
#ifndef vtkImageJReader_h
#define vtkImageJReader_h

#include "vtkTracedObjectsReader.h"

class TRACEREADERS_EXPORT vtkImageJReader : public vtkTracedObjectsReader
{
public:
  static vtkImageJReader* New();
  vtkTypeMacro(vtkImageJReader, vtkTracedObjectsReader);

  /// Whether it is an ROI (.roi) or a set of ROIs (.zip) of ImageJ.
  static int CanReadFile(const char* fileName);

protected:
  vtkImageJReader() = default;
  ~vtkImageJReader() override = default;

  recon::TracedFile ReadObjects(
    const std::vector<std::string>& fileNames, recon::Monitor& monitor) override;
  const char* GetKind() override { return "an ROI (.roi) or a set of ROIs (.zip) of ImageJ"; }

private:
  vtkImageJReader(const vtkImageJReader&) = delete;
  void operator=(const vtkImageJReader&) = delete;
};

#endif
