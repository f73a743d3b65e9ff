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
 * structure set. Cell array `SOPInstanceUID` (strings) names the images. vtkImplicitContours takes
 * the output as its second input.
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

protected:
  vtkDICOMSlicePlanes();
  ~vtkDICOMSlicePlanes() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkDICOMSlicePlanes(const vtkDICOMSlicePlanes&) = delete;
  void operator=(const vtkDICOMSlicePlanes&) = delete;

  char* FileName = nullptr;
};

#endif
