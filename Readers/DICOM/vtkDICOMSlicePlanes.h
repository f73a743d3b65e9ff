// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkDICOMSlicePlanes
 * @brief The planes of the images of a series, as rectangles: where contours have to lie.
 *
 * Reads what vtkRTStructureSetWriter takes as its reference: an RT structure set, whose images'
 * planes are known where something is drawn on them; or an image (CT, MR, PET) of a series, with
 * the others in the same folder; or a folder with the images of one series.
 *
 * Output: a rectangle (polygon) an image, in millimetres of the DICOM patient coordinate system, by
 * increasing offset along the normal: the border of its pixels, or what is around all contours of a
 * structure set. Cell arrays `SOPInstanceUID` (strings), which names the images, and `PixelArea`
 * (double, mm2; 0 where a structure set does not tell it). vtkImplicitContours takes the output as
 * its second input.
 *
 * Field data: `FrameOfReferenceUID`, the frame that the coordinates are in; `ContourTolerance`
 * (double, mm), how near to a slice a contour belongs to it: half the distance of the slices, or
 * 0.1 mm where a structure set does not tell that distance; and `Report` (strings) on images that
 * were left out: those across the series, in another frame of reference, without position, in the
 * plane of another one, and damaged files.
 *
 * What is none of these, damaged, or tells no plane gives one error and an empty output.
 */
#ifndef vtkDICOMSlicePlanes_h
#define vtkDICOMSlicePlanes_h

#include "DICOMReadersModule.h" // for the export macro
#include "vtkContourAlgorithm.h"

class DICOMREADERS_EXPORT vtkDICOMSlicePlanes : public vtkContourAlgorithm
{
public:
  static vtkDICOMSlicePlanes* New();
  vtkTypeMacro(vtkDICOMSlicePlanes, vtkContourAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The structure set, image or folder.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * The frame of reference that the slices must be in: `FrameOfReferenceUID` of the contours that
   * are to lie on them. Slices of another one are refused. Empty, the default: the only one, or the
   * first.
   */
  vtkSetStringMacro(FrameOfReferenceUID);
  vtkGetStringMacro(FrameOfReferenceUID);
  ///@}

protected:
  vtkDICOMSlicePlanes();
  ~vtkDICOMSlicePlanes() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkDICOMSlicePlanes(const vtkDICOMSlicePlanes&) = delete;
  void operator=(const vtkDICOMSlicePlanes&) = delete;

  char* FileName = nullptr;
  char* FrameOfReferenceUID = nullptr;
};

#endif
