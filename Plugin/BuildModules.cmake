# SPDX-License-Identifier: GPL-3.0-or-later
# The VTK modules over the core and the parsers, for ParaView's VTK or for one of one's own. Before it is included:
#   contour_module_folders       the folders that have a vtk.module each
#   contour_requested_modules    modules of others that are needed beside what these ask for
#   contour_module_destination   where the libraries are installed
#   contour_python_destination   where their Python modules are
#   contour_header_options       what vtk_module_build and the modules are told of headers
# After it contour_modules are the modules, contour_wrapped_modules those that Python has.
set(BUILD_SHARED_LIBS ON)
set(contour_module_files ${contour_module_folders})
list(TRANSFORM contour_module_files PREPEND "${PROJECT_SOURCE_DIR}/")
list(TRANSFORM contour_module_files APPEND "/vtk.module")

vtk_module_scan(
  MODULE_FILES ${contour_module_files}
  REQUEST_MODULES ${contour_requested_modules}
  PROVIDES_MODULES contour_modules
  REQUIRES_MODULES external_modules
  WANT_BY_DEFAULT ON
  HIDE_MODULES_FROM_CACHE ON)

# Beside each other, so that what is installed is one folder and needs no library path.
set(CMAKE_INSTALL_RPATH "$ORIGIN")

vtk_module_build(
  MODULES ${contour_modules}
  LIBRARY_DESTINATION "${contour_module_destination}"
  USE_EXTERNAL OFF
  ENABLE_WRAPPING ON
  ${contour_header_options})

if (CONTOUR_WRAP_PYTHON)
  find_package(Python3 REQUIRED COMPONENTS Development.Module)
  # What the window does by itself is nothing for scripts.
  set(contour_wrapped_modules ${contour_modules})
  list(REMOVE_ITEM contour_wrapped_modules ContourWindow)
  vtk_module_wrap_python(
    MODULES ${contour_wrapped_modules}
    TARGET ContourPython
    PYTHON_PACKAGE contourreconstruction
    MODULE_DESTINATION "${contour_python_destination}"
    INSTALL_HEADERS OFF)
endif ()

if (CONTOUR_VTK_WARNINGS)
  foreach (module IN LISTS contour_modules)
    vtk_module_compile_options(${module} PRIVATE ${CONTOUR_VTK_WARNINGS})
  endforeach ()
endif ()

# The generated wrapping of a class is a few lines under headers that take seconds: a compiler a module, not a class.
foreach (module IN LISTS contour_modules)
  foreach (wrapping IN ITEMS CS Python)
    if (TARGET ${module}${wrapping})
      set_target_properties(${module}${wrapping} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
    endif ()
  endforeach ()
endforeach ()
