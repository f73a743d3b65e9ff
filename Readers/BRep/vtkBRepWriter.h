// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkBRepWriter
 * @brief Writes a surface, and the contours that lie in it, as a boundary representation (.brep).
 *
 * The format is that of the thesis's appendix ("BRep file grammar"). A shell is a connected
 * component: triangles that share edges. Where the triangles have a cell array `ShellSet`
 * (vtkBRepReader's), components are grouped by it, otherwise all are one shell set. Coordinates are
 * written with the fewest digits that give the same double again, 17 at most, so that a round trip
 * through vtkBRepReader is exact to the last bit. Points that no triangle uses are not written.
 *
 * Contours come from the lines of the surface, and from the lines and polygons of the optional
 * second input; loose segments are chained first. A contour goes to the CONTOURS of the shell in
 * which it lies: its vertices are points of the surface to the last bit, and between two of them
 * there is an edge of the surface, or a row of edges through points that were added on the
 * contour's edge (thesis 5.1 and 5.2), up to 1e-9 of the surface's size. How many contours lie in
 * no shell is said in a warning. Vertices alone would not do: chords of a triangulated cap join
 * vertices of one contour as well.
 *
 * Every half-edge needs a partner. An edge of more than two triangles, neighbours that are oriented
 * against each other, a polygon that is no triangle, or a coordinate that is not finite give one
 * error, set the error code, and no file is written. A border is allowed, as in the appendix's own
 * example: it becomes a contour, and the next half-edge along it is the partner.
 *
 * Of a collection (the regions of a structure set) each block with a surface gets a file of its own,
 * named by recon::RegionFileNames; contours of a collection are those of the block of the same name.
 * What is wrong with one region costs that one, and is said in the error.
 *
 * @sa vtkBRepReader
 */
#ifndef vtkBRepWriter_h
#define vtkBRepWriter_h

#include "BRepReadersModule.h" // for the export macro
#include "vtkContourWriter.h"

#include <string> // for std::string

class vtkPolyData;

namespace recon
{
class Monitor;
}

class BREPREADERS_EXPORT vtkBRepWriter : public vtkContourWriter
{
public:
  static vtkBRepWriter* New();
  vtkTypeMacro(vtkBRepWriter, vtkContourWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to write; one that is there is replaced.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkBRepWriter();
  ~vtkBRepWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  const char* GetTarget() override { return this->FileName; }
  const char* GetTargetKind() override { return "the file to write (.brep)"; }
  bool HoldsSurfaces() override { return true; }
  void WriteWhole() override;

private:
  void WriteSurface(vtkPolyData* surface, vtkPolyData* contours, const std::string& fileName,
    recon::Monitor& monitor);
  void WriteRegions();

  vtkBRepWriter(const vtkBRepWriter&) = delete;
  void operator=(const vtkBRepWriter&) = delete;

  char* FileName = nullptr;
};

#endif
