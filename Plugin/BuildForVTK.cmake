# SPDX-License-Identifier: GPL-3.0-or-later
# The VTK modules over the core and the parsers for a VTK without ParaView: libraries, headers, a CMake package
# (ContourReconstructionVTK) for programs in C++, and modules for VTK's own Python (contourreconstruction).
include(CMakePackageConfigHelpers)
find_package(VTK 9.1 REQUIRED COMPONENTS
  CommonCore CommonDataModel CommonExecutionModel FiltersCore IOCore ParallelCore
  OPTIONAL_COMPONENTS Python WrappingPythonCore)
if (CONTOUR_WRAP_PYTHON AND NOT VTK_WRAP_PYTHON)
  message(FATAL_ERROR "${VTK_DIR} has a VTK without Python: set CONTOUR_WRAP_PYTHON to OFF.")
endif ()

set(contour_vtk_package_destination "${CMAKE_INSTALL_LIBDIR}/cmake/ContourReconstructionVTK")
set(contour_module_destination "${CMAKE_INSTALL_LIBDIR}/ContourReconstructionVTK")
set(contour_python_destination "${contour_module_destination}/python")
set(contour_requested_modules)
set(contour_header_options
  PACKAGE ContourReconstructionVTK
  INSTALL_EXPORT ContourReconstructionVTK
  CMAKE_DESTINATION "${contour_vtk_package_destination}"
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/ContourReconstructionVTK")
include("${CMAKE_CURRENT_LIST_DIR}/BuildModules.cmake")

configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/ContourReconstructionVTKConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/ContourReconstructionVTKConfig.cmake"
  INSTALL_DESTINATION "${contour_vtk_package_destination}")
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/ContourReconstructionVTKConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES
    "${PROJECT_BINARY_DIR}/ContourReconstructionVTKConfig.cmake"
    "${PROJECT_BINARY_DIR}/ContourReconstructionVTKConfigVersion.cmake"
  DESTINATION "${contour_vtk_package_destination}" COMPONENT Development)
