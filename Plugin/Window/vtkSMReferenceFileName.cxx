// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSMReferenceFileName.h"

#include "PipelineBefore.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMStringVectorProperty.h"

#include <set>
#include <string>

vtkStandardNewMacro(vtkSMReferenceFileName);

namespace
{
std::string TextOf(vtkSMProxy* proxy, const char* name)
{
  auto* property = vtkSMStringVectorProperty::SafeDownCast(proxy->GetProperty(name));
  const char* text =
    property && property->GetNumberOfElements() > 0 ? property->GetElement(0) : nullptr;
  return text ? text : "";
}

/// The DICOM file that a node has its contours from; empty where it has none of its own.
std::string FileOf(vtkSMProxy* proxy, bool alsoOfReaders)
{
  const std::string name = proxy->GetXMLName() ? proxy->GetXMLName() : "";
  return alsoOfReaders && name == "DICOMRTStructureSetReader" ? TextOf(proxy, "FileName")
                                                              : TextOf(proxy, "ReferenceFileName");
}

/// Of the nearest node before this one that has one.
std::string FileBefore(vtkSMProxy* proxy, bool alsoOfReaders)
{
  vtkSMProxy* found =
    FindBefore(proxy, [&](vtkSMProxy* node) { return !FileOf(node, alsoOfReaders).empty(); });
  return found ? FileOf(found, alsoOfReaders) : std::string();
}

/// Of all readers of structure sets there are, where these read one file.
std::string OnlyFile(vtkSMProxy* source)
{
  std::set<std::string> files;
  vtkNew<vtkSMProxyIterator> iterator;
  iterator->SetSession(source->GetSession());
  iterator->SetModeToOneGroup();
  for (iterator->Begin("sources"); !iterator->IsAtEnd(); iterator->Next())
  {
    const char* name = iterator->GetProxy()->GetXMLName();
    if (name && std::string(name) == "DICOMRTStructureSetReader")
    {
      files.insert(TextOf(iterator->GetProxy(), "FileName"));
    }
  }
  return files.size() == 1 ? *files.begin() : std::string();
}
}

//------------------------------------------------------------------------------
void vtkSMReferenceFileName::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType)
{
  const char* name = xml->GetAttribute("property");
  if (!name || !proxy->GetProperty(name) || !TextOf(proxy, name).empty())
  {
    return;
  }
  int alsoOfReaders = 1;
  xml->GetScalarAttribute("readers", &alsoOfReaders);
  const bool hasInput = proxy->GetProperty("Input") != nullptr;
  const std::string file = hasInput ? FileBefore(proxy, alsoOfReaders != 0) : OnlyFile(proxy);
  if (!file.empty())
  {
    vtkSMPropertyHelper(proxy, name).Set(file.c_str());
    proxy->UpdateVTKObjects();
  }
}

//------------------------------------------------------------------------------
void vtkSMReferenceFileName::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
