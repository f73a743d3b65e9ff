# SPDX-License-Identifier: GPL-3.0-or-later
# What others need to use the core and the parsers in programs of their own: libraries, headers, and the package
# that find_package(ContourReconstruction) finds. Documentation/example shows how.
include(CMakePackageConfigHelpers)

set(contour_header_destination "${CMAKE_INSTALL_INCLUDEDIR}/ContourReconstruction")
set(contour_package_destination "${CMAKE_INSTALL_LIBDIR}/cmake/ContourReconstruction")

install(TARGETS ContourCore ContourParsers ContourTraces ContourDICOM
  EXPORT ContourReconstructionTargets
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT Development
  INCLUDES DESTINATION "${contour_header_destination}")

# A folder of their own, so that "Contours/ContourSet.h" means the same in a stranger's program as in here.
install(DIRECTORY "${PROJECT_SOURCE_DIR}/Filters/Core/" "${PROJECT_SOURCE_DIR}/Readers/"
  DESTINATION "${contour_header_destination}" COMPONENT Development
  FILES_MATCHING PATTERN "*.h"
  PATTERN "vtk*.h" EXCLUDE)

install(EXPORT ContourReconstructionTargets
  NAMESPACE ContourReconstruction::
  DESTINATION "${contour_package_destination}" COMPONENT Development)
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/ContourReconstructionConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/ContourReconstructionConfig.cmake"
  INSTALL_DESTINATION "${contour_package_destination}")
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/ContourReconstructionConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES
    "${PROJECT_BINARY_DIR}/ContourReconstructionConfig.cmake"
    "${PROJECT_BINARY_DIR}/ContourReconstructionConfigVersion.cmake"
  DESTINATION "${contour_package_destination}" COMPONENT Development)
