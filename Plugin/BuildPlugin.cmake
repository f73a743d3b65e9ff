# SPDX-License-Identifier: GPL-3.0-or-later
# The VTK modules over the core and the parsers, and the ParaView plugin that is made of them.
include("${CMAKE_CURRENT_LIST_DIR}/PythonModuleNames.cmake")
# The optional one for what ParaView 5.13's own libraries are linked with (HDF5, netCDF): its files then look for that.
find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingCore OPTIONAL_COMPONENTS RemotingServerManager)

set(contour_plugin_subdirectory "paraview-${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}/plugins")
# Beside the plugin.
set(contour_module_destination
  "${CMAKE_INSTALL_LIBDIR}/${contour_plugin_subdirectory}/ContourReconstruction")
set(contour_python_destination "${contour_module_destination}/python")
set(contour_header_options INSTALL_HEADERS OFF PACKAGE contourreconstruction)
list(APPEND contour_module_folders Plugin/Window)

paraview_plugin_scan(
  PLUGIN_FILES "${PROJECT_SOURCE_DIR}/Plugin/paraview.plugin"
  PROVIDES_PLUGINS plugins
  REQUIRES_MODULES contour_requested_modules
  ENABLE_BY_DEFAULT ON)

include("${CMAKE_CURRENT_LIST_DIR}/BuildModules.cmake")

paraview_plugin_build(
  PLUGINS ${plugins}
  # Where ParaView lists it, it has it as well: readers that nobody has loaded open no file.
  AUTOLOAD ContourReconstruction
  PLUGINS_FILE_NAME contour.plugins.xml
  LIBRARY_SUBDIRECTORY "${contour_plugin_subdirectory}"
  INSTALL_HEADERS OFF)

# What a user needs, without the tests: all that is installed.
add_custom_target(plugin DEPENDS ContourReconstruction ContourManPage)
foreach (module IN LISTS contour_wrapped_modules)
  add_dependencies(plugin ${module}Python)
endforeach ()
