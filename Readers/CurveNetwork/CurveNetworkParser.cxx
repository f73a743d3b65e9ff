// SPDX-License-Identifier: GPL-3.0-or-later
#include "CurveNetwork/CurveNetworkParser.h"

#include "Common/TextScanner.h"
#include "CurveNetwork/ContourNetworkParser.h"
#include "CurveNetwork/CSLParser.h"

#include <sstream>

namespace recon
{
namespace
{
/// "P", "a b c d", "V E": a count, four numbers, two counts.
bool BeginsAsContourNetwork(std::istream& start)
{
  std::string token;
  for (int i = 0; i < 7; ++i)
  {
    double number = 0;
    int count = 0;
    const bool isCount = i == 0 || i > 4;
    if (!(start >> token) || !ParseNumber(token, number) ||
      (isCount && (!ParseInteger(token, count) || count < 0)))
    {
      return false;
    }
  }
  return true;
}
}

CurveNetworkFormat CurveNetworkFormatOf(const std::string& fileName)
{
  std::string bytes = ReadStart(fileName, 512);
  if (bytes.compare(0, 3, "\xEF\xBB\xBF") == 0)
  {
    bytes.erase(0, 3);
  }
  std::istringstream start(bytes);
  std::string first;
  start >> first;
  if (first == "CSLC")
  {
    return CurveNetworkFormat::CSL;
  }
  start.seekg(0);
  return BeginsAsContourNetwork(start) ? CurveNetworkFormat::Contour : CurveNetworkFormat::None;
}

CurveNetwork ReadCurveNetwork(const std::string& fileName, Monitor& monitor)
{
  switch (CurveNetworkFormatOf(fileName))
  {
    case CurveNetworkFormat::CSL:
      return ReadCSL(fileName, monitor);
    case CurveNetworkFormat::Contour:
      return ReadContourNetwork(fileName, monitor);
    case CurveNetworkFormat::None:
      break;
  }
  const TextScanner scanner(fileName); // says where the file is absent, empty or binary
  throw Error("Cannot read " + fileName +
    ": expected a cross-section set that begins with 'CSLC', or a curve network that begins with "
    "the number of planes, a plane a b c d and the numbers of its vertices and edges.");
}
}
