// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkRTStructureSetReader
 * @brief Reads the contours of a DICOM RT structure set (.dcm), a block an ROI.
 *
 * The output is a vtkPartitionedDataSetCollection with a block (a vtkPolyData) for every selected
 * ROI, in the order of the file and named as the ROI. Coordinates are millimetres in the DICOM
 * patient coordinate system, in double precision, as they stand in the file.
 *
 * Each block has
 * - a closed polyline a closed contour (its last point id repeats the first), a polyline an open
 * one and a vertex a point; what of these can be used is for the contour set to say, which reports
 * the rest;
 * - cell array `GeometricType` (strings: POINT, OPEN_PLANAR, OPEN_NONPLANAR, CLOSED_PLANAR,
 *   CLOSEDPLANAR_XOR) and `ContourNumber` (int, the item of the ROI's contour sequence, from 1);
 * - field data `ROIName`, `ROINumber`, `ROIType` (RT ROI Interpreted Type, empty where not given),
 *   `ROIColor` (0 to 255, three components; absent where the file gives none),
 *   `FrameOfReferenceUID` (the frame that the coordinates are in; absent where the file names none)
 *   and `Report` (strings that name the ROI, present where something was odd).
 *
 * The field data of the collection has a `Report` with the lines of all blocks and of the file as a
 * whole. What is wrong with a part costs that part only: an ROI without contours, or one whose
 * number another one has, is an empty block, and a malformed contour is left out; each has a line
 * in `Report`. Names are UTF-8, whatever the character sets of the file. Files without preamble and
 * of implicit or explicit VR are read, whatever their name. A file that is damaged, truncated or of
 * another DICOM class gives one error that names the tag, and an empty output.
 *
 * Regions are spread over the pieces that are asked for (Pieces.h): `Report` of the collection is
 * that of all regions in every piece.
 */
#ifndef vtkRTStructureSetReader_h
#define vtkRTStructureSetReader_h

#include "DICOMReadersModule.h" // for the export macro
#include "vtkNew.h"             // for vtkNew
#include "vtkPartitionedDataSetCollectionAlgorithm.h"

#include <cstddef> // for std::size_t
#include <string>  // for std::string
#include <vector>  // for std::vector

class vtkDataArraySelection;

namespace recon
{
struct StructureSetROI;
}

class DICOMREADERS_EXPORT vtkRTStructureSetReader : public vtkPartitionedDataSetCollectionAlgorithm
{
public:
  static vtkRTStructureSetReader* New();
  vtkTypeMacro(vtkRTStructureSetReader, vtkPartitionedDataSetCollectionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * The ROIs by name, and whether each is wanted: all are, to begin with. UpdateInformation fills
   * it. Where several ROIs have one name, their numbers are added: "PTV (4)".
   */
  vtkDataArraySelection* GetROISelection();

  /**
   * Whether the file is a DICOM file of SOP class RT Structure Set Storage, whatever its name.
   */
  static int CanReadFile(const char* fileName);

  vtkMTimeType GetMTime() override;

  /// See vtkContourAlgorithm.
  const char* GetReport();

protected:
  vtkRTStructureSetReader();
  ~vtkRTStructureSetReader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkRTStructureSetReader(const vtkRTStructureSetReader&) = delete;
  void operator=(const vtkRTStructureSetReader&) = delete;

  void UpdateSelection(const std::vector<std::string>& names);
  std::vector<std::size_t> WantedOf(const std::vector<recon::StructureSetROI>& rois);

  char* FileName = nullptr;
  vtkNew<vtkDataArraySelection> ROISelection;
  std::string ReportText;                   // what GetReport gave out last
  std::string ListedFile;                   // whose ROIs are in ROISelection
  std::vector<std::string> UnknownSelected; // selected names that the file does not have
};

#endif
