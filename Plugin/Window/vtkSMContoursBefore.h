// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkSMContoursBefore
 * @brief Gives a writer of surfaces the contours that its surface was made from.
 *
 * Attribute `property` of the XML element names the input property. It becomes what the nearest
 * surface node of this plugin before the writer has as its input; an input that is set already
 * stays, and where there is no such node, it stays empty.
 */
#ifndef vtkSMContoursBefore_h
#define vtkSMContoursBefore_h

#include "ContourWindowModule.h" // for the export macro
#include "vtkSMProxyInitializationHelper.h"

class CONTOURWINDOW_EXPORT vtkSMContoursBefore : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMContoursBefore* New();
  vtkTypeMacro(vtkSMContoursBefore, vtkSMProxyInitializationHelper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp) override;

protected:
  vtkSMContoursBefore() = default;
  ~vtkSMContoursBefore() override = default;

private:
  vtkSMContoursBefore(const vtkSMContoursBefore&) = delete;
  void operator=(const vtkSMContoursBefore&) = delete;
};

#endif
