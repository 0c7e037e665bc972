# SPDX-License-Identifier: BSD-3-Clause
# Installs the build tree into a fresh prefix below SCRATCH and looks for what must not be exported.
file (REMOVE_RECURSE "${SCRATCH}")
execute_process (
  COMMAND ${CMAKE_COMMAND} --install "${BUILD_DIR}" --prefix "${PREFIX}" --config "${CONFIG}"
  OUTPUT_QUIET RESULT_VARIABLE failed)
if (failed)
  message (FATAL_ERROR "cmake --install failed")
endif ()

foreach (name IN ITEMS README.md CHANGELOG.md LICENSE config.h)
  file (GLOB_RECURSE found "${PREFIX}/*/${name}")
  if (NOT found)
    message (FATAL_ERROR "${name} is not installed")
  endif ()
endforeach ()

file (GLOB_RECURSE exported "${PREFIX}/*_targets*.cmake" "${PREFIX}/*.pc")
list (FILTER exported EXCLUDE REGEX "pcl_msf_visualization_targets") # the one that has VTK
if (NOT exported)
  message (FATAL_ERROR "nothing was exported to ${PREFIX}")
endif ()
foreach (file IN LISTS exported)
  file (READ "${file}" text)
  string (REGEX MATCH "-Wall|-Wextra|-Werror|-mavx|-march|-fsanitize|VTK|vtk" leak "${text}")
  if (leak)
    message (FATAL_ERROR "${file} exports ${leak}")
  endif ()
endforeach ()
