# SPDX-License-Identifier: GPL-3.0-or-later
# The Debian package of `./run package`: plugin, command line, manual page, completion, documentation and data of the
# examples; libraries and headers for programs of one's own (component Development) are not in it.
set(contour_package_version "${PROJECT_VERSION}-1")
set(contour_doc "${CMAKE_INSTALL_DATADIR}/doc/contour-reconstruction")
set(contour_package_dir "${CMAKE_CURRENT_BINARY_DIR}/package")
file(MAKE_DIRECTORY "${contour_package_dir}")
set(contour_maintainer "The Contour Reconstruction authors <maintainers@contour-reconstruction.invalid>" CACHE STRING
  "Who maintains the Debian package, with an address: what the field Maintainer says")

# ParaView reads one list of the lists of plugins. Where Debian's ParaView has one (13), ours says the same and names our
# plugin as well, and Debian's is diverted; where it has none (12), ParaView looks beside its own program, and else only
# in folders that no package may use.
set(contour_paraview_dir "${CMAKE_INSTALL_LIBDIR}/paraview-${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}")
set(contour_list "/usr/${contour_paraview_dir}/paraview.conf")
set(contour_lists)
foreach (file IN ITEMS "${contour_list}.distrib" "${contour_list}") # the first where our package is installed here
  if (EXISTS "${file}" AND NOT contour_lists)
    file(READ "${file}" contour_lists)
  endif ()
endforeach ()
if (contour_lists)
  set(contour_list_destination "${contour_paraview_dir}")
  file(WRITE "${contour_package_dir}/paraview.conf" "${contour_lists}plugins/contour.plugins.xml\n")
  foreach (script IN ITEMS preinst postrm)
    configure_file("${CMAKE_CURRENT_LIST_DIR}/${script}.in" "${contour_package_dir}/${script}" @ONLY
      FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
    list(APPEND CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${contour_package_dir}/${script}")
  endforeach ()
  set(contour_list_override "# Debian's list of plugins is diverted, as ParaView reads one only.
contour-reconstruction: diversion-for-unknown-file *")
else ()
  set(contour_list_destination "${CMAKE_INSTALL_BINDIR}")
  file(RELATIVE_PATH contour_plugins_from_bin
    "/prefix/${CMAKE_INSTALL_BINDIR}" "/prefix/${CMAKE_INSTALL_LIBDIR}/${contour_plugin_subdirectory}/contour.plugins.xml")
  configure_file("${CMAKE_CURRENT_LIST_DIR}/paraview.conf.in" "${contour_package_dir}/paraview.conf" @ONLY)
  set(contour_list_override "# ParaView reads the list of its plugins from beside its program; a list is no program.
contour-reconstruction: no-manual-page [usr/bin/paraview.conf]")
endif ()
install(FILES "${contour_package_dir}/paraview.conf" DESTINATION "${contour_list_destination}"
  COMPONENT Debian EXCLUDE_FROM_ALL)

# The changes by Debian's rules beside those that people read.
string(TIMESTAMP contour_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file("${CMAKE_CURRENT_LIST_DIR}/changelog.in" "${contour_package_dir}/changelog.Debian" @ONLY)
find_program(CONTOUR_GZIP gzip)
foreach (file IN ITEMS "${contour_package_dir}/changelog.Debian" "${PROJECT_SOURCE_DIR}/CHANGELOG.md" "${contour_man_page}")
  get_filename_component(name "${file}" NAME)
  string(REPLACE "CHANGELOG.md" "changelog" name "${name}")
  set(packed "${contour_package_dir}/${name}.gz")
  add_custom_command(OUTPUT "${packed}"
    COMMAND "${CONTOUR_GZIP}" -9nc "${file}" > "${packed}"
    DEPENDS "${file}"
    VERBATIM)
  list(APPEND contour_packed "${packed}")
endforeach ()
add_custom_target(ContourPackageFiles DEPENDS ${contour_packed})
add_dependencies(ContourPackageFiles plugin)
list(POP_BACK contour_packed contour_packed_man_page)
install(FILES ${contour_packed} "${CMAKE_CURRENT_LIST_DIR}/copyright" "${PROJECT_SOURCE_DIR}/README.md"
  DESTINATION "${contour_doc}" COMPONENT Debian EXCLUDE_FROM_ALL)
install(FILES "${contour_packed_man_page}" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1"
  COMPONENT Debian EXCLUDE_FROM_ALL)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/Documentation" DESTINATION "${contour_doc}" COMPONENT Debian EXCLUDE_FROM_ALL
  FILES_MATCHING PATTERN "*.md" PATTERN "*.png"
  PATTERN "site" EXCLUDE PATTERN "example" EXCLUDE PATTERN "examples" EXCLUDE)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/Documentation/examples/" DESTINATION "${contour_doc}/examples"
  COMPONENT Debian EXCLUDE_FROM_ALL FILES_MATCHING PATTERN "*.py")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/Data" DESTINATION "${contour_doc}/examples" COMPONENT Debian EXCLUDE_FROM_ALL
  FILES_MATCHING PATTERN "*.cnt" PATTERN "*.csl" PATTERN "derive" EXCLUDE)
configure_file("${CMAKE_CURRENT_LIST_DIR}/lintian-overrides.in"
  "${contour_package_dir}/contour-reconstruction" @ONLY)
install(FILES "${contour_package_dir}/contour-reconstruction"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/lintian/overrides" COMPONENT Debian EXCLUDE_FROM_ALL)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME contour-reconstruction)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_PACKAGE_CONTACT "${contour_maintainer}")
set(CPACK_STRIP_FILES ON)
# What paraview_add_plugin and vtk_module_build install, and ours.
set(CPACK_COMPONENTS_ALL paraview_plugins runtime python Program Debian Unspecified)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_NAME contour-reconstruction)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "planar contours to closed surfaces, plugin for ParaView")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "\
Outlines drawn on slices (CT and MR contours, histology, geology, terrain)
become solids that one can see, measure, print and compute with: exactly
through the contours, smoothly through contours on any planes, or smoothly
with the topology of the exact surface. RT structure sets are read and
written, and a certificate says what a surface is worth.
.
ParaView has the plugin loaded when it starts; contour-reconstruct does the
same on the command line.")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS
  "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/${contour_plugin_subdirectory}/ContourReconstruction"
  "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
# A plugin is good for the ParaView that it was built for, and for no other.
math(EXPR contour_next_minor "${ParaView_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_PACKAGE_DEPENDS
  "paraview (>= ${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}), paraview (<< ${ParaView_VERSION_MAJOR}.${contour_next_minor}~), python3-paraview, python3")
include(CPack)
