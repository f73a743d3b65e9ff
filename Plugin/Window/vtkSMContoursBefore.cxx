// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSMContoursBefore.h"

#include "PipelineBefore.h"

#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <string>

vtkStandardNewMacro(vtkSMContoursBefore);

namespace
{
bool MakesSurfaces(vtkSMProxy* proxy)
{
  const std::string name = proxy->GetXMLName() ? proxy->GetXMLName() : "";
  return name == "PolyhedralSurface" || name == "ImplicitSurface" || name == "FairSurface";
}
}

//------------------------------------------------------------------------------
void vtkSMContoursBefore::PostInitializeProxy(vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType)
{
  const char* name = xml->GetAttribute("property");
  if (!name || !proxy->GetProperty(name) ||
    vtkSMPropertyHelper(proxy, name).GetNumberOfElements() > 0)
  {
    return;
  }
  vtkSMProxy* surface = FindBefore(proxy, MakesSurfaces);
  if (!surface)
  {
    return;
  }
  const vtkSMPropertyHelper contours(surface, "Input");
  if (contours.GetNumberOfElements() > 0)
  {
    vtkSMPropertyHelper(proxy, name).Set(contours.GetAsProxy(), contours.GetOutputPort());
    proxy->UpdateVTKObjects();
  }
}

//------------------------------------------------------------------------------
void vtkSMContoursBefore::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
