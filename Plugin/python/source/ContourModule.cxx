// SPDX-License-Identifier: GPL-3.0-or-later
// The module contour_reconstruction._core: the core and the parsers for Python, without VTK.
#include "GivenData.h"

NB_MODULE(_core, module)
{
  using namespace recon;
  module.attr("__version__") = CONTOUR_VERSION;
  nb::exception<Error> error(module, "Error", PyExc_ValueError);
  nb::exception<NothingToDo>(module, "NothingToDo", error);
  nb::exception<Aborted>(module, "Aborted", PyExc_RuntimeError);
  BindContours(module);
  BindSurfaces(module);
  BindFiles(module);
  BindStructureSets(module);
  BindTraces(module);
}
