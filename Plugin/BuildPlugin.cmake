# SPDX-License-Identifier: GPL-3.0-or-later
# The VTK modules over the core and the parsers, and the ParaView plugin that is made of them.
include("${CMAKE_CURRENT_LIST_DIR}/PythonModuleNames.cmake")
# The optional one for what ParaView 5.13's own libraries are linked with (HDF5, netCDF): its files then look for that.
find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingCore OPTIONAL_COMPONENTS RemotingServerManager)
set(BUILD_SHARED_LIBS ON)

# The VTK modules; each has a vtk.module and a list of its classes.
set(contour_module_files)
foreach (folder IN ITEMS
    Filters/ContourFilters
    Filters/PolyhedralFilters
    Filters/ImplicitFilters
    Plugin/Window
    Readers/BRep
    Readers/CurveNetwork
    Readers/DICOM
    Readers/NUAGES
    Readers/Traces)
  list(APPEND contour_module_files "${PROJECT_SOURCE_DIR}/${folder}/vtk.module")
endforeach ()

set(contour_plugin_subdirectory "paraview-${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}/plugins")

paraview_plugin_scan(
  PLUGIN_FILES "${PROJECT_SOURCE_DIR}/Plugin/paraview.plugin"
  PROVIDES_PLUGINS plugins
  REQUIRES_MODULES required_modules
  ENABLE_BY_DEFAULT ON)

vtk_module_scan(
  MODULE_FILES ${contour_module_files}
  REQUEST_MODULES ${required_modules}
  PROVIDES_MODULES contour_modules
  REQUIRES_MODULES external_modules
  WANT_BY_DEFAULT ON
  HIDE_MODULES_FROM_CACHE ON)

# Beside the plugin, so that an installed plugin is one folder and needs no library path.
set(contour_module_destination
  "${CMAKE_INSTALL_LIBDIR}/${contour_plugin_subdirectory}/ContourReconstruction")
set(CMAKE_INSTALL_RPATH "$ORIGIN")

vtk_module_build(
  MODULES ${contour_modules}
  LIBRARY_DESTINATION "${contour_module_destination}"
  INSTALL_HEADERS OFF
  USE_EXTERNAL OFF
  ENABLE_WRAPPING ON
  PACKAGE contourreconstruction)

if (CONTOUR_WRAP_PYTHON)
  find_package(Python3 REQUIRED COMPONENTS Development.Module)
  # What the window does by itself is nothing for scripts.
  set(contour_wrapped_modules ${contour_modules})
  list(REMOVE_ITEM contour_wrapped_modules ContourWindow)
  set(contour_python_destination "${contour_module_destination}/python")
  vtk_module_wrap_python(
    MODULES ${contour_wrapped_modules}
    TARGET ContourPython
    PYTHON_PACKAGE contourreconstruction
    MODULE_DESTINATION "${contour_python_destination}"
    INSTALL_HEADERS OFF)
endif ()

paraview_plugin_build(
  PLUGINS ${plugins}
  # Where ParaView lists it, it has it as well: readers that nobody has loaded open no file.
  AUTOLOAD ContourReconstruction
  PLUGINS_FILE_NAME contour.plugins.xml
  LIBRARY_SUBDIRECTORY "${contour_plugin_subdirectory}"
  INSTALL_HEADERS OFF)

# The generated wrapping of a class is a few lines under headers that take seconds: a compiler a module, not a class.
foreach (module IN LISTS contour_modules)
  foreach (wrapping IN ITEMS CS Python)
    if (TARGET ${module}${wrapping})
      set_target_properties(${module}${wrapping} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
    endif ()
  endforeach ()
endforeach ()

# What a user needs, without the tests: all that is installed.
add_custom_target(plugin DEPENDS ContourReconstruction ContourManPage)
if (CONTOUR_WRAP_PYTHON)
  foreach (module IN LISTS contour_wrapped_modules)
    add_dependencies(plugin ${module}Python)
  endforeach ()
endif ()
