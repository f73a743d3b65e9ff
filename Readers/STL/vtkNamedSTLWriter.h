// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkNamedSTLWriter
 * @brief Writes the regions of a collection as binary STL files, each by its name.
 *
 * ParaView numbers the files of a collection (organs0.stl, organs1.stl); here "organs.stl" becomes
 * "organs-Heart.stl", "organs-Left_lung.stl", as recon::RegionFileNames has it. Triangles are written
 * by vtkSTLWriter, in single precision, as the format has it, in the coordinates and unit of the
 * input; lines are left out. Where single precision takes the area of triangles, a warning says of
 * how many. A file is written beside its name and renamed when it is whole.
 *
 * Errors, by vtkErrorMacro and the error code: nothing to write, a file that cannot be written, a
 * region with a coordinate that is not finite or beyond single precision. What is wrong with one
 * region costs that one.
 */
#ifndef vtkNamedSTLWriter_h
#define vtkNamedSTLWriter_h

#include "STLWritersModule.h" // for the export macro
#include "vtkContourWriter.h"

#include <string> // for std::string

class vtkPolyData;

class STLWRITERS_EXPORT vtkNamedSTLWriter : public vtkContourWriter
{
public:
  static vtkNamedSTLWriter* New();
  vtkTypeMacro(vtkNamedSTLWriter, vtkContourWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to write, or the one whose name those of the regions are made of; one that is there is
   * replaced.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkNamedSTLWriter() = default;
  ~vtkNamedSTLWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  const char* GetTarget() override { return this->FileName; }
  const char* GetTargetKind() override { return "the file to write (.stl)"; }
  bool HoldsSurfaces() override { return true; }
  void WriteWhole() override;

private:
  void WriteSurface(vtkPolyData* surface, const std::string& name, const std::string& fileName);

  vtkNamedSTLWriter(const vtkNamedSTLWriter&) = delete;
  void operator=(const vtkNamedSTLWriter&) = delete;

  char* FileName = nullptr;
};

#endif
