// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkReconstructReader
 * @brief Reads a series of Reconstruct (.ser) or PyReconstruct (.jser).
 *
 * Coordinates are those of the series, in micrometres; z is the section's index times its thickness.
 * See ReconstructParser.h.
 */
#ifndef vtkReconstructReader_h
#define vtkReconstructReader_h

#include "vtkTracedObjectsReader.h"

class TRACEREADERS_EXPORT vtkReconstructReader : public vtkTracedObjectsReader
{
public:
  static vtkReconstructReader* New();
  vtkTypeMacro(vtkReconstructReader, vtkTracedObjectsReader);

  /// Whether it is a series of Reconstruct (.ser) or PyReconstruct (.jser).
  static int CanReadFile(const char* fileName);

protected:
  vtkReconstructReader() = default;
  ~vtkReconstructReader() override = default;

  recon::TracedFile ReadObjects(
    const std::vector<std::string>& fileNames, recon::Monitor& monitor) override;
  const char* GetKind() override
  {
    return "a series of Reconstruct (.ser) or PyReconstruct (.jser)";
  }

private:
  vtkReconstructReader(const vtkReconstructReader&) = delete;
  void operator=(const vtkReconstructReader&) = delete;
};

#endif
