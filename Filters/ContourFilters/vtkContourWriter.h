// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkContourWriter
 * @brief What every writer of this project has in common: one whole file, also of data that is spread
 * over the ranks of an MPI server.
 *
 * Each rank asks for its own piece, the first one gets all blocks and writes the file, and the others
 * write nothing. The error code is the same on all ranks.
 */
#ifndef vtkContourWriter_h
#define vtkContourWriter_h

#include "ContourFiltersModule.h" // for export macro
#include "vtkSmartPointer.h"      // for vtkSmartPointer
#include "vtkWriter.h"

#include <functional> // for std::function
#include <string>     // for std::string
#include <vector>     // for std::vector

class CONTOURFILTERS_EXPORT vtkContourWriter : public vtkWriter
{
public:
  vtkTypeMacro(vtkContourWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

protected:
  vtkContourWriter();
  ~vtkContourWriter() override;

  void WriteData() override;

  /// What the file is called, and what it is: "the file to write (.brep)".
  virtual const char* GetTarget() = 0;
  virtual const char* GetTargetKind() = 0;
  /// Whether blocks are surfaces, which must not have come to several ranks in parts.
  virtual bool HoldsSurfaces() { return false; }
  /// Writes the file on the first rank. @throws recon::Error
  virtual void WriteWhole() = 0;

  /// All of an input, for WriteWhole; nullptr where none is connected.
  vtkDataObject* GetWhole(int port = 0);

private:
  vtkContourWriter(const vtkContourWriter&) = delete;
  void operator=(const vtkContourWriter&) = delete;

  std::vector<vtkSmartPointer<vtkDataObject>> Inputs; // a port each, while it is written
};

#endif
