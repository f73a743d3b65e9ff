// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/DICOMTextConversion.h"

#include "DICOM/DICOMCharacterSet.h"

#include <algorithm>
#include <utility>

namespace recon
{
namespace
{
/// Whether Specific Character Set holds for elements of this kind (PS3.5 6.1.2.3).
bool IsText(DcmEVR vr)
{
  return vr == EVR_SH || vr == EVR_LO || vr == EVR_ST || vr == EVR_LT || vr == EVR_UC ||
    vr == EVR_UT || vr == EVR_PN;
}

std::vector<DcmElement*> ElementsOf(DcmItem& item)
{
  std::vector<DcmElement*> elements;
  for (unsigned long i = 0; i < item.card(); ++i)
  {
    elements.push_back(item.getElement(i));
  }
  return elements;
}

void ConvertElement(
  DcmElement& element, const DICOMCharacterSet& set, std::vector<std::string>& unexplained)
{
  OFString text;
  if (element.getOFStringArray(text).bad() || text.empty())
  {
    return;
  }
  const DecodedText decoded =
    set.Decode(std::string(text.c_str(), text.size()), element.ident() == EVR_PN);
  if (decoded.Outcome == DecodedText::How::Unknown)
  {
    const std::string name = TagName(element.getTag());
    if (std::find(unexplained.begin(), unexplained.end(), name) == unexplained.end())
    {
      unexplained.push_back(name);
    }
  }
  element.putOFStringArray(OFString(decoded.Text.c_str(), decoded.Text.size()));
}

void ConvertItem(DcmItem& item, DICOMCharacterSet set, std::vector<std::string>& unexplained)
{
  if (item.tagExists(DCM_SpecificCharacterSet))
  {
    // Of an item in a sequence it holds for that item.
    set = DICOMCharacterSet(GetText(item, DCM_SpecificCharacterSet));
    item.findAndDeleteElement(DCM_SpecificCharacterSet);
  }
  for (DcmElement* element : ElementsOf(item))
  {
    if (auto* sequence = dynamic_cast<DcmSequenceOfItems*>(element))
    {
      for (DcmItem* inner : ItemsOf(*sequence))
      {
        ConvertItem(*inner, set, unexplained);
      }
    }
    else if (IsText(element->ident()))
    {
      ConvertElement(*element, set, unexplained);
    }
  }
}
}

std::vector<std::string> ConvertToUTF8(DcmItem& item)
{
  std::vector<std::string> unexplained;
  ConvertItem(item, DICOMCharacterSet(""), unexplained);
  Put(item, DCM_SpecificCharacterSet, "ISO_IR 192");
  return unexplained;
}
}
