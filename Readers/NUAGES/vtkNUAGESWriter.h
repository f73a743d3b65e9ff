// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkNUAGESWriter
 * @brief Writes contours on planes perpendicular to z to a NUAGES file (.cnt).
 *
 * Every closed polyline and every polygon becomes a contour; loose segments and open polylines
 * (what ParaView's Slice gives) are chained to closed ones first. Sections are written by
 * increasing z. Coordinates are written with the fewest digits that give the same double again, so
 * that a round trip through vtkNUAGESReader is exact to the last bit.
 *
 * The format wants outer contours clockwise and holes counterclockwise: where the input has the
 * cell array `Depth` of vtkContourHierarchy, contours are turned accordingly; otherwise they keep
 * the orientation they have.
 *
 * Input is a vtkPolyData, or a composite data set with exactly one that is not empty. Where a
 * contour's plane is not perpendicular to z, a contour does not close, or a coordinate is not
 * finite, there is one error, and no file is written. Loose vertices are no contours: they are left
 * out with a warning.
 *
 * @sa vtkNUAGESReader
 */
#ifndef vtkNUAGESWriter_h
#define vtkNUAGESWriter_h

#include "NUAGESReadersModule.h" // for the export macro
#include "vtkContourWriter.h"

class vtkPolyData;

class NUAGESREADERS_EXPORT vtkNUAGESWriter : public vtkContourWriter
{
public:
  static vtkNUAGESWriter* New();
  vtkTypeMacro(vtkNUAGESWriter, vtkContourWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to write; one that is there is replaced.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkNUAGESWriter();
  ~vtkNUAGESWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  const char* GetTarget() override { return this->FileName; }
  const char* GetTargetKind() override { return "the NUAGES file to write (.cnt)"; }
  void WriteWhole() override;

private:
  vtkNUAGESWriter(const vtkNUAGESWriter&) = delete;
  void operator=(const vtkNUAGESWriter&) = delete;

  char* FileName = nullptr;
};

#endif
