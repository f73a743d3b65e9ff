// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/ReferenceImages.h"

#include "Base/Text.h"
#include "DICOM/LoadDICOM.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

namespace recon
{
namespace
{
/// Sine of the angle from which on an image lies across another: one degree.
constexpr double Across = 0.0175;
/// Names that a sentence tells.
constexpr std::size_t MostNames = 3;

struct Image
{
  std::string FileName;
  std::string Series;
  std::string Frame;
  bool HasPlane = false;
  bool IsLocalizer = false; ///< as it says itself
  ReferenceSlice Slice;
};

void GetCount(DcmItem& image, const DcmTagKey& key, int& count)
{
  Uint16 value = 0;
  if (image.findAndGetUint16(key, value).good() && value > 0)
  {
    count = value;
  }
}

ReferenceSlice SliceOf(DcmItem& image)
{
  ReferenceSlice slice;
  slice.ClassUID = GetUID(image, DCM_SOPClassUID);
  slice.InstanceUID = GetUID(image, DCM_SOPInstanceUID);
  Vector3 row{};
  Vector3 column{};
  Point3 corner{};
  for (unsigned long a = 0; a < 3; ++a)
  {
    GetNumber(image, DCM_ImageOrientationPatient, a, row[a]);
    GetNumber(image, DCM_ImageOrientationPatient, a + 3, column[a]);
    GetNumber(image, DCM_ImagePositionPatient, a, corner[a]);
  }
  slice.Normal = SliceNormal(Cross(row, column));
  slice.Offset = Dot(slice.Normal, corner);
  // The position is the centre of the first pixel; the first spacing is that of the rows.
  double spacing[2] = { 1, 1 };
  int rows = 1;
  int columns = 1;
  if (GetNumber(image, DCM_PixelSpacing, 0, spacing[0]) &&
    GetNumber(image, DCM_PixelSpacing, 1, spacing[1]))
  {
    slice.PixelArea = std::abs(spacing[0] * spacing[1]);
  }
  GetCount(image, DCM_Rows, rows);
  GetCount(image, DCM_Columns, columns);
  const Vector3 across = (columns * spacing[1]) * row;
  const Vector3 down = (rows * spacing[0]) * column;
  const Point3 start = corner - (0.5 * spacing[1] * row + 0.5 * spacing[0] * column);
  slice.Outline = { start, start + across, start + across + down, start + down };
  return slice;
}

bool IsNamedAsDICOM(const std::filesystem::path& path)
{
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension == ".dcm";
}

class FolderOfImages
{
public:
  FolderOfImages(const std::string& folder, std::vector<std::string>& report)
    : Folder(folder),
      Report(report)
  {
  }

  void Scan(Monitor& monitor);
  /// Leaves those of one series. @throws Error
  void KeepSeries(std::string series);
  /// Leaves those that lie and are meant as most do.
  /// @throws Error where none is left.
  void KeepMost();

  std::vector<Image> Images;

private:
  [[noreturn]] void Fail(const std::string& sentence) const
  {
    throw Error("Cannot take " + this->Folder + " as reference: " + sentence);
  }
  void Add(const std::filesystem::path& path);
  void KeepDirection();
  /// Leaves those that wanted() takes, and tells of the others.
  template <typename Wanted>
  void Keep(const std::string& sentence, Wanted wanted);

  const std::string& Folder;
  std::vector<std::string>& Report;
  std::vector<std::string> Damaged;
};

std::string BaseName(const std::string& fileName)
{
  return std::filesystem::path(fileName).filename().string();
}

void FolderOfImages::Add(const std::filesystem::path& path)
{
  if (!BeginsAsDICOM(path.string()))
  {
    if (IsNamedAsDICOM(path))
    {
      this->Damaged.push_back(BaseName(path.string()));
    }
    return;
  }
  DcmFileFormat file;
  if (!LoadDICOMUntil(path.string(), file, DCM_PixelData).empty())
  {
    this->Damaged.push_back(BaseName(path.string()));
    return;
  }
  DcmItem& data = *file.getDataset();
  Image image;
  image.FileName = path.string();
  image.Series = GetUID(data, DCM_SeriesInstanceUID);
  image.Frame = GetUID(data, DCM_FrameOfReferenceUID);
  image.IsLocalizer = GetText(data, DCM_ImageType).find("LOCALIZER") != std::string::npos;
  image.HasPlane = HasPlane(data);
  if (image.HasPlane)
  {
    image.Slice = SliceOf(data);
    image.HasPlane = Norm(image.Slice.Normal) > 0;
  }
  if (!image.HasPlane && image.Series.empty() && !data.tagExists(DCM_DirectoryRecordSequence))
  {
    // Every image is of some series: this one is cut off between two elements before that.
    this->Damaged.push_back(BaseName(path.string()));
    return;
  }
  this->Images.push_back(std::move(image));
}

void FolderOfImages::Scan(Monitor& monitor)
{
  std::vector<std::filesystem::path> paths;
  std::error_code status;
  for (const auto& entry : std::filesystem::directory_iterator(this->Folder, status))
  {
    if (entry.is_regular_file(status))
    {
      paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    monitor.Update(
      static_cast<double>(i) / static_cast<double>(paths.size()), "reading the reference");
    this->Add(paths[i]);
  }
  if (!this->Damaged.empty())
  {
    this->Report.push_back("Files beside the images are damaged or truncated; no contour refers to "
                           "them or comes to lie on them: " +
      Listed(this->Damaged, MostNames) + ".");
  }
}

template <typename Wanted>
void FolderOfImages::Keep(const std::string& sentence, Wanted wanted)
{
  std::vector<Image> kept;
  std::vector<std::string> leftOut;
  for (Image& image : this->Images)
  {
    if (wanted(image))
    {
      kept.push_back(std::move(image));
    }
    else
    {
      leftOut.push_back(BaseName(image.FileName));
    }
  }
  this->Images = std::move(kept);
  if (!leftOut.empty() && !sentence.empty())
  {
    this->Report.push_back(sentence + ": " + Listed(leftOut, MostNames) + ".");
  }
}

void FolderOfImages::KeepSeries(std::string series)
{
  const auto first = std::find_if(
    this->Images.begin(), this->Images.end(), [](const Image& image) { return image.HasPlane; });
  if (first == this->Images.end())
  {
    this->Fail("there are no images with position and orientation in it" +
      (this->Damaged.empty() ? std::string(".")
                             : ", and damaged ones: " + Listed(this->Damaged, MostNames) + "."));
  }
  if (series.empty())
  {
    series = first->Series;
    if (std::any_of(this->Images.begin(), this->Images.end(),
          [&series](const Image& image) { return image.HasPlane && image.Series != series; }))
    {
      this->Fail("it has images of several series; give one image of the series that is meant.");
    }
  }
  this->Keep("", [&series](const Image& image) { return image.Series == series; });
}

void FolderOfImages::KeepMost()
{
  this->Keep("Images of the series without position or orientation, whose planes are unknown, were "
             "left out",
    [](const Image& image) { return image.HasPlane; });
  if (this->Images.empty())
  {
    this->Fail("no image of the series tells its plane.");
  }
  std::map<std::string, std::size_t> frames;
  for (const Image& image : this->Images)
  {
    ++frames[image.Frame];
  }
  const auto usual = std::max_element(
    frames.begin(), frames.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  this->Keep("Images of the series that have another frame of reference than most were left out",
    [&usual](const Image& image) { return image.Frame == usual->first; });

  const bool areAll = std::all_of(
    this->Images.begin(), this->Images.end(), [](const Image& image) { return image.IsLocalizer; });
  this->Keep("Localizers among the images of the series were left out",
    [areAll](const Image& image) { return areAll || !image.IsLocalizer; });
  this->KeepDirection();
}

void FolderOfImages::KeepDirection()
{
  const Image* middle = nullptr;
  std::size_t most = 0;
  const auto isAcross = [](const Image& a, const Image& b)
  { return Norm(Cross(a.Slice.Normal, b.Slice.Normal)) > Across; };
  for (const Image& image : this->Images)
  {
    const auto count = static_cast<std::size_t>(std::count_if(this->Images.begin(),
      this->Images.end(), [&](const Image& other) { return !isAcross(image, other); }));
    if (count > most)
    {
      most = count;
      middle = &image;
    }
    if (2 * most > this->Images.size())
    {
      break;
    }
  }
  // Images about an axis have no usual direction: each of them is meant.
  if (2 * most > this->Images.size())
  {
    const Image usualImage = *middle;
    this->Keep("Images of the series that lie across most others, as localizers do, were left out",
      [&](const Image& image) { return !isAcross(usualImage, image); });
  }
}
}

bool HasPlane(DcmItem& image)
{
  double ignored = 0;
  return GetNumber(image, DCM_ImagePositionPatient, 2, ignored) &&
    GetNumber(image, DCM_ImageOrientationPatient, 5, ignored);
}

ReferenceImages ReadReferenceImages(
  const std::string& folder, const std::string& series, Monitor& monitor)
{
  ReferenceImages result;
  FolderOfImages found(folder, result.Report);
  found.Scan(monitor);
  found.KeepSeries(series);
  for (const Image& image : found.Images)
  {
    result.FileNames.push_back(image.FileName);
  }
  found.KeepMost();
  for (const Image& image : found.Images)
  {
    result.Slices.push_back(image.Slice);
  }
  LoadDICOMUntil(found.Images.front().FileName, result.First, DCM_PixelData); // as it was before
  return result;
}
}
