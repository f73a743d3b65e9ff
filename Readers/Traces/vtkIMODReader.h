// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class vtkIMODReader
 * @brief Reads the objects of an IMOD model (.mod).
 *
 * Coordinates are pixels times the model's pixel size, in its unit (`LengthUnit`), z times its scale of z
 * as well. See IMODParser.h.
 */
#ifndef vtkIMODReader_h
#define vtkIMODReader_h

#include "vtkTracedObjectsReader.h"

class TRACEREADERS_EXPORT vtkIMODReader : public vtkTracedObjectsReader
{
public:
  static vtkIMODReader* New();
  vtkTypeMacro(vtkIMODReader, vtkTracedObjectsReader);

  /// Whether it is an IMOD model (.mod).
  static int CanReadFile(const char* fileName);

protected:
  vtkIMODReader() = default;
  ~vtkIMODReader() override = default;

  recon::TracedFile ReadObjects(
    const std::vector<std::string>& fileNames, recon::Monitor& monitor) override;
  const char* GetKind() override { return "an IMOD model (.mod)"; }

private:
  vtkIMODReader(const vtkIMODReader&) = delete;
  void operator=(const vtkIMODReader&) = delete;
};

#endif
