// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Soundness.h
 * @brief What a parser hands on holds together, whatever the file: for tests of files that nobody looked at.
 *
 * Each says what is wrong in words, and nothing where nothing is.
 */
#ifndef Soundness_h
#define Soundness_h

#include "Base/Monitor.h"
#include "Common/ContourFile.h"
#include "Common/TracedFile.h"
#include "CurveNetwork/CurveNetwork.h"
#include "DICOM/DICOMText.h"
#include "DICOM/StructureSetFile.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace readertesting
{
/// A sentence in one line of UTF-8; the last may stand in parentheses.
inline std::string FaultOf(const std::string& sentence)
{
  const std::size_t last = sentence.find_last_not_of(')');
  return last == std::string::npos                        ? "a sentence is empty"
    : sentence[last] != '.'                               ? "no full stop: " + sentence
    : sentence.find_first_of("\n\r") != std::string::npos ? "several lines: " + sentence
    : !recon::IsUTF8(sentence)                            ? "no UTF-8: " + sentence
                                                          : "";
}

inline std::string FaultOf(const std::vector<std::string>& report)
{
  for (const std::string& line : report)
  {
    const std::string fault = FaultOf(line);
    if (!fault.empty())
    {
      return fault;
    }
  }
  return {};
}

inline std::string FaultOf(const recon::LoopSoup& soup)
{
  for (const recon::Point3& p : soup.Points)
  {
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      return "a coordinate is not finite";
    }
  }
  const int count = static_cast<int>(soup.Points.size());
  for (const recon::LoopSoup::Chain& chain : soup.Chains)
  {
    if (!std::all_of(chain.Points.begin(), chain.Points.end(),
          [count](int point) { return point >= 0 && point < count; }))
    {
      return "a chain has a point that is not there";
    }
  }
  return {};
}

inline std::string FaultOf(const recon::ContourFile& file)
{
  const std::string fault = FaultOf(file.Report);
  return fault.empty() ? FaultOf(file.Soup) : fault;
}

inline std::string FaultOf(const recon::CurveNetwork& network)
{
  std::string fault = FaultOf(network.Report);
  for (const recon::MaterialContours& material : network.Materials)
  {
    fault = fault.empty() ? FaultOf(material.Soup) : fault;
    if (material.Planes.size() != material.Soup.Chains.size())
    {
      fault = "chains without a plane";
    }
  }
  return fault;
}

inline std::string FaultOf(const recon::TracedFile& file)
{
  std::string fault = FaultOf(file.Report);
  for (const recon::TracedObject& object : file.Objects)
  {
    fault = fault.empty() ? FaultOf(object.Soup) : fault;
    if (!recon::IsUTF8(object.Name))
    {
      fault = "a name is no UTF-8: " + object.Name;
    }
    const std::size_t count = object.Soup.Chains.size();
    if (object.Slices.size() != count || (!object.Names.empty() && object.Names.size() != count))
    {
      fault = "chains without a slice or a name";
    }
  }
  return fault;
}

/// With the contours of all ROIs.
inline std::string FaultOf(recon::StructureSetFile& file, recon::Monitor& monitor)
{
  std::string fault = FaultOf(file.GetReport());
  std::set<std::string> names;
  for (std::size_t i = 0; i < file.GetROIs().size(); ++i)
  {
    const std::string& name = file.GetROIs()[i].Name;
    const recon::StructureSetContours contours = file.ReadContours(static_cast<int>(i), monitor);
    fault = fault.empty() ? FaultOf(contours.File) : fault;
    if (!recon::IsUTF8(name) || !names.insert(name).second)
    {
      fault = "a name is no UTF-8, or another ROI's: " + name;
    }
    if (contours.GeometricTypes.size() != contours.File.Soup.Chains.size())
    {
      fault = "chains without a type";
    }
  }
  return fault;
}
}

#endif
