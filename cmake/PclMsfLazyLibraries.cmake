# SPDX-License-Identifier: BSD-3-Clause
# Libraries that are loaded by the call that needs them, not by every program's start.

# pcl_msf_lazy_library (module SYMBOL...): a module of OpenCV of which only these
# functions are called. Sets in the caller's scope
#   PCL_MSF_<MODULE>_FILES  names by which it is loaded, a list of C strings; empty if it has
#                           to be linked, since it is no shared library with these symbols
#   PCL_MSF_<MODULE>_LINK   the target to link in that case
function (pcl_msf_lazy_library module)
  set (target opencv_${module})
  string (TOUPPER "PCL_MSF_${module}" name)
  get_target_property (configurations ${target} IMPORTED_CONFIGURATIONS)
  list (GET configurations 0 configuration)
  get_target_property (file ${target} IMPORTED_LOCATION_${configuration})
  get_target_property (soname ${target} IMPORTED_SONAME_${configuration})
  pcl_msf_choose_lazy (${name} ${target} "${file}" "${soname}" ${ARGN})
endfunction ()

# pcl_msf_lazy_pcl_library (component SYMBOL...): the same of a library of PCL that
# PclMsfPlainPcl has found.
function (pcl_msf_lazy_pcl_library component)
  string (TOUPPER "PCL_MSF_PCL_${component}" name)
  set (file "${PCL_MSF_PCL_${component}_LIBRARY}")
  set (soname "")
  if (CMAKE_OBJDUMP)
    execute_process (COMMAND ${CMAKE_OBJDUMP} -p "${file}" OUTPUT_VARIABLE head ERROR_QUIET)
    if (head MATCHES "SONAME +([^ \n]+)")
      set (soname "${CMAKE_MATCH_1}")
    endif ()
  endif ()
  pcl_msf_choose_lazy (
    ${name} pcl_msf::plain_pcl_${component} "${file}" "${soname}" ${ARGN})
endfunction ()

# Sets <name>_FILES and <name>_LINK in the scope around the calling function.
macro (pcl_msf_choose_lazy name target file soname)
  pcl_msf_has_symbols (found "${file}" ${ARGN})
  if (found AND NOT "${soname}" MATCHES "^$|NOTFOUND" AND PCL_MSF_LAZY_LIBRARIES AND CMAKE_SYSTEM_NAME STREQUAL "Linux")
    set (${name}_FILES "\"${soname}\",\"${file}\"" PARENT_SCOPE)
    set (${name}_LINK "" PARENT_SCOPE)
  else ()
    set (${name}_FILES "" PARENT_SCOPE)
    set (${name}_LINK ${target} PARENT_SCOPE)
  endif ()
endmacro ()

# Sets RESULT to whether a shared library defines all of the functions.
function (pcl_msf_has_symbols result file)
  set (${result} FALSE PARENT_SCOPE)
  if (NOT CMAKE_NM OR NOT EXISTS "${file}")
    return ()
  endif ()
  execute_process (COMMAND ${CMAKE_NM} -D --defined-only "${file}"
    OUTPUT_VARIABLE symbols ERROR_QUIET)
  foreach (symbol IN LISTS ARGN)
    if (NOT symbols MATCHES " T ${symbol}[@\n]")
      return ()
    endif ()
  endforeach ()
  set (${result} TRUE PARENT_SCOPE)
endfunction ()
