// SPDX-License-Identifier: GPL-3.0-or-later
#include "Reconstruct/ReconstructParser.h"

#include "Common/JSONText.h"
#include "Common/TextFile.h"
#include "Common/TextScanner.h"
#include "Reconstruct/JSONSeries.h"
#include "Reconstruct/XMLSeries.h"

#include <string_view>

namespace recon
{
namespace
{
/// What tells both apart, wherever it stands in the beginning of the file.
enum class Kind
{
  None,
  Series,
  JSON
};

Kind KindOf(const std::string& start)
{
  const std::size_t first = start.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (first == std::string::npos)
  {
    return Kind::None;
  }
  if (start[first] == '<' && start.find("<Series") != std::string::npos)
  {
    return Kind::Series;
  }
  return start[first] == '{' ? Kind::JSON : Kind::None;
}

constexpr std::size_t StartSize = 4096;
}

bool IsReconstruct(const std::string& fileName)
{
  const std::string start = ReadStart(fileName, StartSize);
  const Kind kind = KindOf(start);
  // Much is JSON; a series names its sections, or begins with one, whose images, traces and
  // transforms have these names.
  return kind == Kind::Series ||
    (kind == Kind::JSON &&
      (start.find("\"sections\"") != std::string::npos ||
        start.find("\"tforms\"") != std::string::npos));
}

TracedFile ReadReconstruct(const std::string& fileName, Monitor& monitor)
{
  const std::string text = ReadTextFile(fileName);
  switch (KindOf(text.substr(0, StartSize)))
  {
    case Kind::Series:
      return ReadXMLSeries(fileName, text, monitor);
    case Kind::JSON:
      return ReadJSONSeries(fileName, text, monitor);
    default:
      throw Error("Cannot read " + fileName +
        ": it is no series file of Reconstruct (.ser, XML) or PyReconstruct (.jser, JSON).");
  }
}
}
