# SPDX-License-Identifier: GPL-3.0-or-later
# Debian's package names Python modules after the Python that they are for (vtkCommonCore.cpython-313-....so), but
# the CMake files of ParaView 5.13 beside it ask for vtkCommonCore.so, and end with an error where a file is missing.
# Nothing is linked with these modules. So for each of them that is there under its long name only, the question is
# answered beforehand: CMake's import files (3.28 and later) ask for no file of a target that is a folder.
file(GLOB contour_long_names
  "/usr/lib/python3/dist-packages/vtkmodules/*.cpython-*.so"
  "/usr/lib/python3/dist-packages/paraview/*/*.cpython-*.so")
foreach (file IN LISTS contour_long_names)
  get_filename_component(folder "${file}" DIRECTORY)
  get_filename_component(name "${file}" NAME_WE)
  if (NOT EXISTS "${folder}/${name}.so")
    foreach (namespace IN ITEMS VTK ParaView)
      set("_cmake_import_check_xcframework_for_${namespace}::${name}Python" "${folder}")
    endforeach ()
  endif ()
endforeach ()
