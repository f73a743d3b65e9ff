// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkContoursOnSlices
 * @brief Contours that were drawn on some planes, on all slices of a series between them, in one
 * node.
 *
 * Input: contours as vtkPolyData, in millimetres of the DICOM patient coordinate system; a
 * collection (the regions of a structure set) is done region by region. ReferenceFileName: an RT
 * structure set, or one image of a series, whose slices are meant; the frame of reference is that of
 * the input's field data `FrameOfReferenceUID`, where it has one.
 *
 * Output: closed polylines on the slices with the arrays of vtkContourHierarchy, and the field data
 * of the input, so that vtkRTStructureSetWriter gives the region its name, number, colour and type
 * back; `Report` says on how many slices, and what was left out.
 *
 * Errors (a sentence through vtkErrorMacro, and no output): no reference, or one that tells no
 * slices in the frame of reference; no slice between the outermost drawn points; what the method
 * refuses.
 *
 * @sa vtkDICOMSlicePlanes, vtkImplicitContours, vtkPolyhedralSurface, whose defaults are taken
 */
#ifndef vtkContoursOnSlices_h
#define vtkContoursOnSlices_h

#include "DICOMReadersModule.h" // for the export macro
#include "vtkContourSetAlgorithm.h"

#include <memory> // for std::unique_ptr

class DICOMREADERS_EXPORT vtkContoursOnSlices : public vtkContourSetAlgorithm
{
public:
  static vtkContoursOnSlices* New();
  vtkTypeMacro(vtkContoursOnSlices, vtkContourSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The structure set, or image of the series, that tells the slices.
   */
  vtkSetFilePathMacro(ReferenceFileName);
  vtkGetFilePathMacro(ReferenceFileName);
  ///@}

  enum MethodType
  {
    Implicit = 0,
    Polyhedral = 1
  };

  ///@{
  /**
   * Implicit, the default: smooth, from contours on any planes. Polyhedral: from contours on
   * parallel planes, straight between them; slices that are drawn on keep what was drawn.
   */
  vtkSetClampMacro(Method, int, Implicit, Polyhedral);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /**
   * Also on slices beyond the outermost drawn points, where the implicit surface closes. Off by
   * default, as nobody drew anything there. Without effect on Polyhedral, which ends with what was
   * drawn.
   */
  vtkSetMacro(Extrapolate, bool);
  vtkGetMacro(Extrapolate, bool);
  vtkBooleanMacro(Extrapolate, bool);
  ///@}

  ///@{
  /**
   * Contours of a smaller area are left out, with a line in `Report`; in mm2. 0, the default: those
   * that are smaller than a pixel of the images and than half of any contour that was drawn.
   * Negative: none.
   */
  vtkSetMacro(SmallestArea, double);
  vtkGetMacro(SmallestArea, double);
  ///@}

  ///@{
  /**
   * Number of threads; 0, the default, takes all of the machine. The result does not depend on it.
   */
  vtkSetClampMacro(Threads, int, 0, 1024);
  vtkGetMacro(Threads, int);
  ///@}

protected:
  vtkContoursOnSlices();
  ~vtkContoursOnSlices() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkContoursOnSlices(const vtkContoursOnSlices&) = delete;
  void operator=(const vtkContoursOnSlices&) = delete;

  struct KnownSlices;
  const KnownSlices& ReadSlices(const std::string& frame, recon::Monitor& monitor);

  char* ReferenceFileName = nullptr;
  int Method = Implicit;
  bool Extrapolate = false;
  double SmallestArea = 0;
  int Threads = 0;
  std::unique_ptr<KnownSlices> Known;
};

#endif
