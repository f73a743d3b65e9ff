// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkRTStructureSetWriter
 * @brief Writes contours to a DICOM RT structure set (.dcm).
 *
 * Input is a vtkPolyData, which becomes a region of interest (ROI), or a composite data set, each
 * block of which does. Closed polylines and polygons become closed contours, in any plane; loose
 * segments (what ParaView's Slice gives) are chained to closed ones first. Cell array
 * `GeometricType` and field data `ROIName`, `ROINumber`, `ROIType`, `ROIColor`,
 * `FrameOfReferenceUID`, as vtkRTStructureSetReader gives them and the filters of this project pass them on, are kept;
 * without the name that of the block is taken. Lines of type OPEN_PLANAR and OPEN_NONPLANAR stay
 * open (those not as planar as they say become OPEN_NONPLANAR), and vertices become points where
 * their type is POINT or the block has nothing else.
 *
 * ReferenceFileName gives patient, study, frame of reference and the images that the contours refer
 * to. The file is a structure set of its own: identifiers, date and series are new, its approval
 * status is UNAPPROVED, and it names the reference as its predecessor. ROIs of the reference come
 * along unless CopyReferenceROIs is off, and are never replaced: a new ROI whose name or number is
 * taken gets another one. An ROI is written in the frame of reference that it was drawn in, and
 * refers to the images of that frame; one whose frame the reference does not have is left out with
 * a warning, or an error where no other is left. In a series, images that lie across most others
 * (localizers) are no slices.
 *
 * Coordinates are millimetres in the DICOM patient coordinate system, written with up to six
 * decimals: what is read back differs by at most 5e-7 mm. The transfer syntax is Implicit VR Little
 * Endian, the one that every system reads and that has room for contours of any length. Texts are
 * in the reference's character set where all new names are ASCII, and in UTF-8 otherwise.
 *
 * Holes are contours of their own (see Holes). DICOM has no sign for them: that of a CLOSED_PLANAR
 * contour within another is a hole is a convention, which vtkContourHierarchy and most planning
 * systems follow.
 *
 * The file is written beside its name and renamed, so that there is a whole file or none. What was
 * left out or renamed is a warning, a sentence each. No file is written, and there is one error and
 * an ErrorCode, where there are no contours; one is not planar, does not close, or has a coordinate
 * that is not a number; the input is a surface; the reference is no structure set or image, is
 * damaged, or is the file to write; or the file cannot be written.
 *
 * @sa vtkRTStructureSetReader
 */
#ifndef vtkRTStructureSetWriter_h
#define vtkRTStructureSetWriter_h

#include "DICOMReadersModule.h" // for the export macro
#include "vtkContourWriter.h"

class DICOMREADERS_EXPORT vtkRTStructureSetWriter : public vtkContourWriter
{
public:
  static vtkRTStructureSetWriter* New();
  vtkTypeMacro(vtkRTStructureSetWriter, vtkContourWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum HolesAs
  {
    SeparateContours,
    ExclusiveOr,
    Keyholes
  };

  enum GenerationAlgorithms
  {
    Automatic,
    Semiautomatic,
    Manual
  };

  ///@{
  /**
   * The file to write; one that is there is replaced, but not the reference.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Where patient, study, frame of reference and images come from: an RT structure set; or an image
   * (CT, MR, PET), with those of its series in the same folder; or a folder with the images of one
   * series. None by default: the file then names no patient and has a frame of reference of its
   * own.
   *
   * A contour refers to the image whose plane it lies on within half the distance of the slices.
   * A structure set tells the planes of those images only that something is drawn on; where the
   * distance of the slices cannot be told from them, a contour must lie within 0.1 mm of one.
   */
  vtkSetFilePathMacro(ReferenceFileName);
  vtkGetFilePathMacro(ReferenceFileName);
  ///@}

  ///@{
  /**
   * Whether the ROIs of a reference that is a structure set are written as well, as they are there.
   * On by default, so that the new file can take the place of the old one.
   */
  vtkSetMacro(CopyReferenceROIs, bool);
  vtkGetMacro(CopyReferenceROIs, bool);
  vtkBooleanMacro(CopyReferenceROIs, bool);
  ///@}

  ///@{
  /**
   * Name of the one ROI of the input, in UTF-8; empty, the default: that of the data, or of the
   * block, or "Contours". At most 64 characters.
   */
  vtkSetStringMacro(ROIName);
  vtkGetStringMacro(ROIName);
  ///@}

  ///@{
  /**
   * RT ROI Interpreted Type of all ROIs of the input, such as ORGAN, PTV, CTV, GTV, EXTERNAL,
   * AVOIDANCE; empty, the default: that of the data.
   */
  vtkSetStringMacro(ROIType);
  vtkGetStringMacro(ROIType);
  ///@}

  ///@{
  /**
   * Structure Set Label, what planning systems list the file by; at most 16 characters.
   * "Reconstruction" by default.
   */
  vtkSetStringMacro(StructureSetLabel);
  vtkGetStringMacro(StructureSetLabel);
  ///@}

  ///@{
  /**
   * ROI Generation Algorithm of the new ROIs. Semiautomatic by default: computed from what somebody
   * has drawn.
   */
  vtkSetClampMacro(GenerationAlgorithm, int, Automatic, Manual);
  vtkGetMacro(GenerationAlgorithm, int);
  ///@}

  ///@{
  /**
   * SeparateContours (default): every closed contour is CLOSED_PLANAR, and one within another is
   * taken for a hole by convention. ExclusiveOr: CLOSEDPLANAR_XOR, for which the standard says so,
   * but which systems from before 2017 do not know. Keyholes: each hole is joined to what is around
   * it by a bridge that is walked in both directions, for systems that know no holes; contours are
   * cleaned first, as vtkContourHierarchy does. An ROI with a contour of type CLOSEDPLANAR_XOR is
   * written that way but for Keyholes.
   */
  vtkSetClampMacro(Holes, int, SeparateContours, Keyholes);
  vtkGetMacro(Holes, int);
  ///@}

protected:
  vtkRTStructureSetWriter();
  ~vtkRTStructureSetWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  const char* GetTarget() override { return this->FileName; }
  const char* GetTargetKind() override { return "the RT structure set to write (.dcm)"; }
  void WriteWhole() override;

private:
  vtkRTStructureSetWriter(const vtkRTStructureSetWriter&) = delete;
  void operator=(const vtkRTStructureSetWriter&) = delete;

  char* FileName = nullptr;
  char* ReferenceFileName = nullptr;
  bool CopyReferenceROIs = true;
  char* ROIName = nullptr;
  char* ROIType = nullptr;
  char* StructureSetLabel = nullptr;
  int GenerationAlgorithm = Semiautomatic;
  int Holes = SeparateContours;
};

#endif
