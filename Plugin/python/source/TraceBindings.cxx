// SPDX-License-Identifier: GPL-3.0-or-later
// What tracing and drawing programs save, for Python.
#include "GivenData.h"
#include "ImageJ/ImageJParser.h"
#include "IMOD/IMODParser.h"
#include "PythonMonitor.h"
#include "Reconstruct/ReconstructParser.h"
#include "SVG/SVGParser.h"
#include "Table/ContourTableParser.h"

namespace recon
{
namespace
{
/// Of this content: "IMOD", "ImageJ", "Reconstruct", "SVG", "Table" or empty.
std::string TraceFormatOf(const std::string& fileName)
{
  return IsIMOD(fileName)      ? "IMOD"
    : IsImageJ(fileName)       ? "ImageJ"
    : IsReconstruct(fileName)  ? "Reconstruct"
    : IsSVG(fileName)          ? "SVG"
    : IsContourTable(fileName) ? "Table"
                               : "";
}

TracedFile ReadTraces(
  const std::vector<std::string>& fileNames, const SliceStack& stack, Monitor& monitor)
{
  const std::string& first = fileNames.front();
  const std::string format = TraceFormatOf(first);
  if (format == "SVG")
  {
    return ReadSVG(fileNames, stack, monitor);
  }
  if (fileNames.size() > 1)
  {
    throw Error("Several files make one stack only where they are drawings (.svg), and " + first +
      " is none.");
  }
  if (format == "IMOD")
  {
    return ReadIMOD(first, monitor);
  }
  if (format == "ImageJ")
  {
    return ReadImageJ(first, stack, monitor);
  }
  if (format == "Reconstruct")
  {
    return ReadReconstruct(first, monitor);
  }
  return ReadContourTable(first, stack, monitor); // which says what is wrong with any other file
}

std::string TypeOf(const LoopSoup::Chain& chain)
{
  return chain.Points.size() == 1 ? "POINT" : chain.Closed ? "CLOSED_PLANAR" : "OPEN_PLANAR";
}

nb::dict FromObject(const TracedObject& object, int number, const std::string& unit)
{
  std::vector<int> order;
  nb::dict result = FromSoup(object.Soup, order);
  std::vector<std::string> types;
  std::vector<std::string> names;
  for (const int chain : order)
  {
    const auto i = static_cast<std::size_t>(chain);
    types.push_back(TypeOf(object.Soup.Chains[i]));
    names.push_back(i < object.Names.size() ? object.Names[i] : std::string());
  }
  nb::dict cells;
  cells["GeometricType"] = ToList(types);
  cells["Slice"] = ArrayOf(order, [&](int chain) { return object.Slices[chain]; });
  if (!object.Names.empty())
  {
    cells["Name"] = ToList(names);
  }
  nb::dict field;
  field["ROIName"] = object.Name;
  field["ROINumber"] = number;
  if (object.HasColor)
  {
    field["ROIColor"] =
      nb::make_tuple(int(object.Color[0]), int(object.Color[1]), int(object.Color[2]));
  }
  field["LengthUnit"] = unit;
  result["cell_data"] = cells;
  result["field_data"] = field;
  return result;
}

nb::dict ReadTraceFiles(
  const nb::list& fileNames, double spacing, double pixel, nb::handle progress)
{
  const std::vector<std::string> names = ToLines(fileNames);
  const TracedFile file = RunWithoutLock(progress,
    [&](Monitor& monitor) {
      return ReadTraces(names, { spacing, pixel }, monitor);
    });
  nb::list objects;
  for (std::size_t i = 0; i < file.Objects.size(); ++i)
  {
    objects.append(FromObject(file.Objects[i], static_cast<int>(i) + 1, file.LengthUnit));
  }
  nb::dict result;
  result["objects"] = objects;
  result["report"] = ToList(file.Report);
  return result;
}
}

void BindTraces(nb::module_& module)
{
  module.def("trace_format_of", &TraceFormatOf, nb::arg("file_name"));
  module.def("read_traces", &ReadTraceFiles, nb::arg("file_names"), nb::arg("spacing"),
    nb::arg("pixel"), nb::arg("progress").none());
}
}
