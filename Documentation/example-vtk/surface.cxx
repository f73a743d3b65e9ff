// SPDX-License-Identifier: GPL-3.0-or-later
// Contours of a NUAGES file (.cnt) in, the closed surface through them out (.stl), as a pipeline of VTK.
#include <vtkNew.h>
#include <vtkNUAGESReader.h>
#include <vtkPolyhedralSurface.h>
#include <vtkSTLWriter.h>

int main(int argc, char** argv)
{
  if (argc != 3)
  {
    return 2;
  }
  vtkNew<vtkNUAGESReader> contours;
  contours->SetFileName(argv[1]);
  vtkNew<vtkPolyhedralSurface> surface;
  surface->SetInputConnection(contours->GetOutputPort());
  vtkNew<vtkSTLWriter> file;
  file->SetInputConnection(surface->GetOutputPort());
  file->SetFileName(argv[2]);
  file->Write();
  return file->GetErrorCode() == 0 && surface->GetErrorCode() == 0 ? 0 : 1;
}
