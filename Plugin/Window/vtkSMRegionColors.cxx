// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSMRegionColors.h"

#include "vtkDataAssembly.h"
#include "vtkDataAssemblyUtilities.h"
#include "vtkDataSetAttributes.h"
#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMStringVectorProperty.h"

#include <array>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSMRegionColors);

namespace
{
/// How much of the body's outline is seen, so that what is within it is, too.
constexpr const char* OutlineOpacity = "0.2";
constexpr double OutlineOpacityNumber = 0.2;

struct Region
{
  bool HasColor = false;
  std::array<double, 3> Color{};
  bool IsOutline = false;
};

bool HasScalars(vtkPVDataInformation* data)
{
  return data->GetPointDataInformation()->GetAttributeInformation(vtkDataSetAttributes::SCALARS) ||
    data->GetCellDataInformation()->GetAttributeInformation(vtkDataSetAttributes::SCALARS);
}

/// What field data say of one region; nothing of several, or of other data.
Region RegionIn(vtkPVDataInformation* data)
{
  Region region;
  vtkPVDataSetAttributesInformation* field = data->GetFieldDataInformation();
  vtkPVArrayInformation* color = field->GetArrayInformation("ROIColor");
  if (!color || color->GetNumberOfComponents() != 3 || color->GetNumberOfTuples() != 1 ||
    HasScalars(data))
  {
    return region;
  }
  region.HasColor = true;
  for (int c = 0; c < 3; ++c)
  {
    region.Color[c] = color->GetComponentRange(c)[0] / 255;
  }
  vtkPVArrayInformation* type = field->GetArrayInformation("ROIType");
  const char* name = type && type->GetNumberOfStringValues() > 0 ? type->GetStringValue(0) : "";
  region.IsOutline = name && std::string(name) == "EXTERNAL";
  return region;
}

/// With a decimal point, whatever the locale.
std::string TextOf(double number)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << number;
  return text.str();
}

void SetTexts(vtkSMProxy* proxy, const char* property, const std::vector<std::string>& texts)
{
  auto* target = vtkSMStringVectorProperty::SafeDownCast(proxy->GetProperty(property));
  if (target && target->GetNumberOfElements() == 0 && !texts.empty())
  {
    target->SetElements(texts);
  }
}

/// Apply colours blocks by their number, and shows a legend of that, which says nothing where all have
/// colours of their own; it does not where all blocks have one number.
void LeaveOutBlockColors(vtkSMProxy* proxy)
{
  const char* name = "BlockColorsDistinctValues";
  if (proxy->GetProperty(name))
  {
    vtkSMPropertyHelper(proxy, name).Set(1);
  }
}

void ColorBlocks(vtkSMProxy* proxy, vtkSMSourceProxy* source, unsigned int port)
{
  vtkDataAssembly* hierarchy = source->GetDataInformation(port)->GetHierarchy();
  std::vector<std::string> colors;
  std::vector<std::string> opacities;
  bool allHaveColors = true;
  for (const int node : hierarchy->GetChildNodes(vtkDataAssembly::GetRootNode()))
  {
    const std::string selector = hierarchy->GetNodePath(node);
    vtkPVDataInformation* data = source->GetSubsetDataInformation(
      port, selector.c_str(), vtkDataAssemblyUtilities::HierarchyName());
    const Region region = data ? RegionIn(data) : Region();
    allHaveColors = allHaveColors && region.HasColor;
    if (!region.HasColor)
    {
      continue;
    }
    colors.push_back(selector);
    for (const double part : region.Color)
    {
      colors.push_back(TextOf(part));
    }
    if (region.IsOutline)
    {
      opacities.insert(opacities.end(), { selector, OutlineOpacity });
    }
  }
  SetTexts(proxy, "BlockColors", colors);
  SetTexts(proxy, "BlockOpacities", opacities);
  if (allHaveColors && !colors.empty())
  {
    LeaveOutBlockColors(proxy);
  }
}

/// A property that nobody has set since the representation was begun.
bool IsUntouched(vtkSMProxy* proxy, const char* name, vtkMTimeType begun)
{
  return proxy->GetProperty(name) && proxy->GetProperty(name)->GetMTime() <= begun;
}

void ColorWhole(vtkSMProxy* proxy, vtkPVDataInformation* data, vtkMTimeType begun)
{
  const Region region = RegionIn(data);
  for (const char* name : { "AmbientColor", "DiffuseColor" })
  {
    if (region.HasColor && IsUntouched(proxy, name, begun))
    {
      vtkSMPropertyHelper(proxy, name).Set(region.Color.data(), 3);
    }
  }
  if (region.IsOutline && IsUntouched(proxy, "Opacity", begun))
  {
    vtkSMPropertyHelper(proxy, "Opacity").Set(OutlineOpacityNumber);
  }
}
}

//------------------------------------------------------------------------------
void vtkSMRegionColors::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement*, vtkMTimeType initializationTimeStamp)
{
  if (!proxy->GetProperty("Input"))
  {
    return;
  }
  const vtkSMPropertyHelper input(proxy, "Input");
  auto* source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  if (!source)
  {
    return;
  }
  const unsigned int port = input.GetOutputPort();
  vtkPVDataInformation* data = source->GetDataInformation(port);
  if (data->IsCompositeDataSet())
  {
    ColorBlocks(proxy, source, port);
  }
  else
  {
    ColorWhole(proxy, data, initializationTimeStamp);
  }
  proxy->UpdateVTKObjects();
}

//------------------------------------------------------------------------------
void vtkSMRegionColors::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
