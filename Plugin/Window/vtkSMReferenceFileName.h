// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkSMReferenceFileName
 * @brief Begins the name of the DICOM file that slices come from as that of the structure set that
 * the contours were read from.
 *
 * Attribute `property` of the XML element names the property. Of a node with inputs the reader is
 * the nearest one before it in the pipeline (DICOM RT Structure Set Reader, or a node with a
 * ReferenceFileName of its own); of a source without inputs the only such reader there is. A name
 * that is set already stays, and where there is no such reader, or more than one to choose from,
 * the name stays empty. With the attribute `readers="0"` readers do not count, only nodes with a
 * ReferenceFileName: for writers, which scripts mean to write without a reference where they give none.
 */
#ifndef vtkSMReferenceFileName_h
#define vtkSMReferenceFileName_h

#include "ContourWindowModule.h" // for the export macro
#include "vtkSMProxyInitializationHelper.h"

class CONTOURWINDOW_EXPORT vtkSMReferenceFileName : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMReferenceFileName* New();
  vtkTypeMacro(vtkSMReferenceFileName, vtkSMProxyInitializationHelper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp) override;

protected:
  vtkSMReferenceFileName() = default;
  ~vtkSMReferenceFileName() override = default;

private:
  vtkSMReferenceFileName(const vtkSMReferenceFileName&) = delete;
  void operator=(const vtkSMReferenceFileName&) = delete;
};

#endif
