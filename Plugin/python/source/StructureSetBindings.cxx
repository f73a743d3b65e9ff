// SPDX-License-Identifier: GPL-3.0-or-later
// DICOM RT structure sets, and the planes of a series, for Python.
#include "Base/SubMonitor.h"
#include "DICOM/ReadReferenceSlices.h"
#include "DICOM/ROIContours.h"
#include "DICOM/StructureSetFile.h"
#include "GivenData.h"
#include "PythonMonitor.h"

#include <nanobind/stl/vector.h>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcdict.h>

#include <algorithm>
#include <cstdlib>

namespace recon
{
namespace
{
bool IsStructureSetFile(const std::string& fileName)
{
  try
  {
    return StructureSetFile::IsStructureSet(fileName);
  }
  catch (const std::exception&)
  {
    return false; // whatever it is, it is nothing that can be read here
  }
}

/**
 * Loads the data dictionary that comes with the package, as the machine may have no DCMTK; one that
 * DCMDICTPATH names is left as it is.
 */
bool LoadDictionary(const std::string& fileName)
{
  if (std::getenv("DCMDICTPATH") != nullptr)
  {
    return dcmDataDict.isDictionaryLoaded();
  }
  setenv("DCMDICTPATH", fileName.c_str(), 1);
  const bool isLoaded = dcmDataDict.isDictionaryLoaded();
  unsetenv("DCMDICTPATH"); // what others start is none of ours
  return isLoaded;
}

nb::dict FromROI(const StructureSetROI& roi)
{
  nb::dict field;
  field["ROIName"] = roi.Name;
  field["ROIType"] = roi.Type;
  if (!roi.FrameOfReferenceUID.empty())
  {
    field["FrameOfReferenceUID"] = roi.FrameOfReferenceUID;
  }
  field["ROINumber"] = roi.Number;
  if (roi.HasColor)
  {
    field["ROIColor"] = nb::make_tuple(roi.Color[0], roi.Color[1], roi.Color[2]);
  }
  return field;
}

nb::dict FromContours(const StructureSetROI& roi, const StructureSetContours& contours)
{
  std::vector<int> order;
  nb::dict result = FromSoup(contours.File.Soup, order);
  std::vector<std::string> types;
  for (const int chain : order)
  {
    types.push_back(contours.GeometricTypes[chain]);
  }
  nb::dict cells;
  cells["GeometricType"] = ToList(types);
  cells["ContourNumber"] =
    ArrayOf(order, [&](int chain) { return contours.File.Soup.Chains[chain].Source + 1; });
  result["cell_data"] = cells;
  result["field_data"] = FromROI(roi);
  result["report"] = ToList(contours.File.Report);
  return result;
}

nb::list ListROIs(const std::string& fileName)
{
  const StructureSetFile file(fileName);
  nb::list rois;
  for (const StructureSetROI& roi : file.GetROIs())
  {
    nb::dict described = FromROI(roi);
    described["NumberOfContours"] = roi.NumberOfContours;
    rois.append(described);
  }
  return rois;
}

struct ReadROI
{
  StructureSetROI Description;
  StructureSetContours Contours;
};

std::vector<ReadROI> ReadROIs(
  StructureSetFile& file, const std::vector<std::string>& names, bool all, Monitor& monitor)
{
  const std::vector<StructureSetROI>& rois = file.GetROIs();
  const auto count = static_cast<double>(rois.size());
  std::vector<ReadROI> result;
  for (std::size_t i = 0; i < rois.size(); ++i)
  {
    if (all || std::find(names.begin(), names.end(), rois[i].Name) != names.end())
    {
      SubMonitor reading(
        monitor, static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
      result.push_back({ rois[i], file.ReadContours(static_cast<int>(i), reading) });
    }
  }
  return result;
}

nb::dict ReadStructureSet(const std::string& fileName, nb::handle rois, nb::handle progress)
{
  const bool all = rois.is_none();
  const std::vector<std::string> names = all ? std::vector<std::string>() : ToLines(rois);
  std::vector<std::string> report;
  const std::vector<ReadROI> read = RunWithoutLock(progress,
    [&](Monitor& monitor)
    {
      StructureSetFile file(fileName);
      report = file.GetReport();
      return ReadROIs(file, names, all, monitor);
    });
  nb::list blocks;
  for (const ReadROI& roi : read)
  {
    blocks.append(FromContours(roi.Description, roi.Contours));
    const std::vector<std::string>& more = roi.Contours.File.Report;
    report.insert(report.end(), more.begin(), more.end());
  }
  nb::dict result;
  result["rois"] = blocks;
  result["report"] = ToList(report);
  return result;
}

/// What a dictionary says of an ROI; what it does not say is left to the writer.
StructureSetROI DescriptionOf(const nb::dict& roi)
{
  StructureSetROI description;
  description.Name = ValueOf<std::string>(roi, "ROIName");
  description.Type = ValueOf<std::string>(roi, "ROIType");
  description.FrameOfReferenceUID = ValueOf<std::string>(roi, "FrameOfReferenceUID");
  description.Number = ValueOf<int>(roi, "ROINumber");
  const nb::object color = roi["ROIColor"];
  if (!color.is_none())
  {
    description.HasColor = true;
    for (int c = 0; c < 3; ++c)
    {
      description.Color[c] = std::clamp(nb::cast<int>(color[c]), 0, 255);
    }
  }
  return description;
}

ROIPiece PieceOf(const nb::dict& roi)
{
  ROIPiece piece;
  piece.Soup = SoupOf(nb::cast<nb::dict>(roi["loops"]));
  piece.GeometricTypes = ToLines(roi["types"]);
  piece.OnlyVertices = std::all_of(piece.Soup.Chains.begin(), piece.Soup.Chains.end(),
    [](const LoopSoup::Chain& chain) { return chain.Points.size() == 1; });
  return piece;
}

StructureSetOptions OptionsOf(const nb::dict& properties)
{
  static const char* const algorithms[] = { "AUTOMATIC", "SEMIAUTOMATIC", "MANUAL" };
  StructureSetOptions options;
  options.Reference = ValueOf<std::string>(properties, "ReferenceFileName");
  options.CopyReferenceROIs = ValueOf<bool>(properties, "CopyReferenceROIs");
  options.Label = ValueOf<std::string>(properties, "StructureSetLabel");
  options.GenerationAlgorithm = algorithms[ValueOf<int>(properties, "GenerationAlgorithm")];
  options.ExclusiveOr = ValueOf<int>(properties, "Holes") == 1;
  return options;
}

nb::list WriteStructureSetFile(const std::string& fileName, const nb::list& rois,
  const nb::dict& properties, nb::handle progress)
{
  const StructureSetOptions options = OptionsOf(properties);
  const bool keyholes = ValueOf<int>(properties, "Holes") == 2;
  std::vector<WrittenROI> written;
  std::vector<ROIPiece> pieces;
  for (const nb::handle given : rois)
  {
    const auto roi = nb::borrow<nb::dict>(given);
    written.push_back({ DescriptionOf(roi), {} });
    pieces.push_back(PieceOf(roi));
  }
  return ToList(RunWithoutLock(progress,
    [&](Monitor& monitor)
    {
      std::vector<std::string> report;
      ROIContours contours(keyholes, report, monitor);
      for (std::size_t i = 0; i < pieces.size(); ++i)
      {
        contours.Collect(pieces[i], written[i]);
      }
      const std::vector<std::string> more =
        WriteStructureSet(fileName, std::move(written), options, monitor);
      report.insert(report.end(), more.begin(), more.end());
      return report;
    }));
}

/// A rectangle an image.
nb::dict ReadSlicePlanes(const std::string& fileName, const std::string& frame, nb::handle progress)
{
  const SlicesOfReference slices = RunWithoutLock(
    progress, [&](Monitor& monitor) { return ReadReferenceSlices(fileName, frame, monitor); });
  LoopSoup soup;
  std::vector<std::string> images;
  for (const ReferenceSlice& slice : slices.Slices)
  {
    soup.Append({ slice.Outline.begin(), slice.Outline.end() });
    images.push_back(slice.InstanceUID);
  }
  std::vector<int> order;
  nb::dict result = FromSoup(soup, order);
  nb::dict cells;
  cells["SOPInstanceUID"] = ToList(images);
  cells["PixelArea"] =
    ArrayOf(slices.Slices, [](const ReferenceSlice& slice) { return slice.PixelArea; });
  nb::dict field;
  field["FrameOfReferenceUID"] = slices.FrameOfReferenceUID;
  field["ContourTolerance"] = slices.Tolerance;
  result["cell_data"] = cells;
  result["field_data"] = field;
  result["report"] = ToList(slices.Report);
  return result;
}
}

void BindStructureSets(nb::module_& module)
{
  module.def("load_dictionary", &LoadDictionary, nb::arg("file_name"));
  module.def("is_structure_set", &IsStructureSetFile, nb::arg("file_name"));
  module.def("list_rois", &ListROIs, nb::arg("file_name"));
  module.def("read_structure_set", &ReadStructureSet, nb::arg("file_name"), nb::arg("rois").none(),
    nb::arg("progress").none());
  module.def("write_structure_set", &WriteStructureSetFile, nb::arg("file_name"), nb::arg("rois"),
    nb::arg("properties"), nb::arg("progress").none());
  module.def("read_slice_planes", &ReadSlicePlanes, nb::arg("file_name"), nb::arg("frame"),
    nb::arg("progress").none());
}
}
