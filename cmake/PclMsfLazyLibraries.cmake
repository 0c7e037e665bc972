# SPDX-License-Identifier: BSD-3-Clause
# Libraries that are loaded by the call that needs them, not by every program's start.

# pcl_msf_lazy_library (MODULE module SYMBOL...): a module of OpenCV of which only these
# functions are called. Sets in the caller's scope
#   PCL_MSF_<MODULE>_FILES  names by which it is loaded, a list of C strings; empty if it has
#                           to be linked, since it is no shared library with these symbols
#   PCL_MSF_<MODULE>_LINK   the target to link in that case
function (pcl_msf_lazy_library module)
  set (target opencv_${module})
  string (TOUPPER "PCL_MSF_${module}" name)
  set (${name}_FILES "" PARENT_SCOPE)
  set (${name}_LINK ${target} PARENT_SCOPE)
  if (NOT PCL_MSF_LAZY_LIBRARIES OR NOT CMAKE_SYSTEM_NAME STREQUAL "Linux" OR NOT CMAKE_NM)
    return ()
  endif ()
  get_target_property (configurations ${target} IMPORTED_CONFIGURATIONS)
  list (GET configurations 0 configuration)
  get_target_property (file ${target} IMPORTED_LOCATION_${configuration})
  get_target_property (soname ${target} IMPORTED_SONAME_${configuration})
  if (NOT file OR NOT soname)
    return ()
  endif ()
  execute_process (COMMAND ${CMAKE_NM} -D --defined-only "${file}"
    OUTPUT_VARIABLE symbols ERROR_QUIET)
  foreach (symbol IN LISTS ARGN)
    if (NOT symbols MATCHES " T ${symbol}[@\n]")
      return ()
    endif ()
  endforeach ()
  set (${name}_FILES "\"${soname}\",\"${file}\"" PARENT_SCOPE)
  set (${name}_LINK "" PARENT_SCOPE)
endfunction ()
