// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file DICOMItem.h
 * @brief What reading and writing of DICOM share: DCMTK's items, their texts, numbers and contours.
 *
 * For the sources of this folder only, because it takes in DCMTK's headers.
 */
#ifndef recon_DICOMItem_h
#define recon_DICOMItem_h

#include "Base/Geometry.h"
#include "Common/TextScanner.h"

// DCMTK's own order: its configuration comes first.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcdeftag.h>
#include <dcmtk/dcmdata/dcfilefo.h>
#include <dcmtk/dcmdata/dcsequen.h>
#include <dcmtk/oflog/oflog.h>

#include <string>
#include <string_view>
#include <vector>

namespace recon
{
/// DCMTK prints what it meets to the terminal; the user gets one sentence from us instead.
class QuietDCMTK
{
public:
  QuietDCMTK() { this->Logger.setLogLevel(OFLogger::OFF_LOG_LEVEL); }
  ~QuietDCMTK() { this->Logger.setLogLevel(this->Before); }
  QuietDCMTK(const QuietDCMTK&) = delete;
  QuietDCMTK& operator=(const QuietDCMTK&) = delete;

private:
  OFLogger Logger = OFLog::getLogger("dcmtk");
  OFLogger::LogLevel Before = this->Logger.getChainedLogLevel();
};

/// "ContourData (3006,0050)"
std::string TagName(const DcmTagKey& key);

/// Without what DICOM and its writers pad with: spaces, NULs, line ends.
std::string_view Trimmed(std::string_view text);

/// All values of an element, trimmed; empty where the item does not have it.
std::string GetText(DcmItem& item, const DcmTagKey& key);
/// A unique identifier, which sentences may show: '?' for all but the digits and full stops that it may have, and no more
/// than the 64 of them that it may have.
std::string GetUID(DcmItem& item, const DcmTagKey& key);
bool GetNumber(DcmItem& item, const DcmTagKey& key, int& value);
/// A value of several, such as a coordinate.
bool GetNumber(DcmItem& item, const DcmTagKey& key, unsigned long index, double& value);

std::vector<DcmItem*> ItemsOf(DcmSequenceOfItems& sequence);
/// The items of a sequence; none where the item does not have it, or has something else there.
std::vector<DcmItem*> ItemsOf(DcmItem& item, const DcmTagKey& key);

/// Calls visit with every value between backslashes.
template <typename Visitor>
void ForEachValue(std::string_view text, Visitor visit)
{
  for (;;)
  {
    const std::size_t end = text.find('\\');
    visit(Trimmed(text.substr(0, end)));
    if (end == std::string_view::npos)
    {
      return;
    }
    text.remove_prefix(end + 1);
  }
}

/// Whether a file begins as DICOM files do, with preamble or without; nothing is said of the rest.
bool BeginsAsDICOM(const std::string& fileName);

/// "RTStructureSetStorage", or the UID itself where DCMTK does not know it.
std::string ClassName(const std::string& uid);

/// The points of a contour, or why there are none.
struct ContourPoints
{
  std::vector<Point3> Points; ///< millimetres; none where the item has no contour data
  /// Of data that are not whole triples of numbers: what was expected. Completes "it cannot be
  /// used: ".
  std::string Fault;
  bool HasNumbers = true; ///< of such data, whether at least each value is a number
};

/// The points of an item of a contour sequence. A backslash behind the last number is passed over,
/// as some writers leave it there.
ContourPoints GetContourPoints(DcmItem& contour);

/// Sets an element, in place of one that is there. @throws Error where DCMTK refuses.
void Put(DcmItem& item, const DcmTagKey& key, const std::string& value);
/// A copy of an element, where from has it.
void CopyElement(DcmItem& from, const DcmTagKey& key, DcmItem& to);
/// A new last item of a sequence, which is made where there is none.
DcmItem& AppendItem(DcmItem& parent, const DcmTagKey& sequence);

/// A new unique identifier under 2.25, which needs no registration (PS3.5 B.2).
std::string NewUID();
}

#endif
