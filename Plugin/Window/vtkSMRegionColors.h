// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkSMRegionColors
 * @brief Shows regions of a structure set in the colours that the file gives them.
 *
 * When a representation of a collection comes about, each block whose field data have `ROIColor`
 * gets it as its colour, and one whose `ROIType` is EXTERNAL, the body's outline, which is around all
 * others, is made translucent, contours and surfaces. One region alone gets the colour of the representation.
 *
 * Blocks that have scalars to be coloured by keep these, and colours that the user has set stay.
 */
#ifndef vtkSMRegionColors_h
#define vtkSMRegionColors_h

#include "ContourWindowModule.h" // for the export macro
#include "vtkSMProxyInitializationHelper.h"

class CONTOURWINDOW_EXPORT vtkSMRegionColors : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMRegionColors* New();
  vtkTypeMacro(vtkSMRegionColors, vtkSMProxyInitializationHelper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp) override;

protected:
  vtkSMRegionColors() = default;
  ~vtkSMRegionColors() override = default;

private:
  vtkSMRegionColors(const vtkSMRegionColors&) = delete;
  void operator=(const vtkSMRegionColors&) = delete;
};

#endif
