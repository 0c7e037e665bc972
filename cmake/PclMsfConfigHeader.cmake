# SPDX-License-Identifier: BSD-3-Clause
# pcl_msf/config.h: the version, and how Eigen aligns and allocates under the flags that
# the library is compiled with. A consumer's flags may differ, see build_compatibility.h.

# The flags of all targets in this directory, as a list.
function (pcl_msf_common_flags result)
  string (TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
  separate_arguments (flags UNIX_COMMAND
    "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}}")
  get_property (options DIRECTORY PROPERTY COMPILE_OPTIONS)
  get_property (definitions DIRECTORY PROPERTY COMPILE_DEFINITIONS)
  list (TRANSFORM definitions PREPEND "-D")
  list (APPEND flags ${options} ${definitions})
  list (FILTER flags EXCLUDE REGEX "\\$<") # nobody evaluates them here
  if (PCL_MSF_SANITIZE)
    list (APPEND flags -DEIGEN_MALLOC_ALREADY_ALIGNED=1) # see pcl_msf_target_settings
  endif ()
  set (${result} ${flags} PARENT_SCOPE)
endfunction ()

# Sets PCL_MSF_EIGEN_STATIC, _HEAP and _MALLOC, in the cache until the flags change.
function (pcl_msf_ask_eigen)
  pcl_msf_common_flags (flags)
  set (key "${CMAKE_CXX_COMPILER} ${CMAKE_CXX_COMPILER_VERSION} ${Eigen3_VERSION} ${flags}")
  if (PCL_MSF_EIGEN_KEY STREQUAL key)
    return ()
  endif ()
  set (program "${PROJECT_BINARY_DIR}/eigen_layout")
  try_compile (compiled "${PROJECT_BINARY_DIR}/CMakeFiles/eigen_layout"
    "${PROJECT_SOURCE_DIR}/cmake/eigen_layout.cpp"
    COMPILE_DEFINITIONS ${flags} LINK_LIBRARIES Eigen3::Eigen
    OUTPUT_VARIABLE output COPY_FILE "${program}")
  if (NOT compiled)
    message (FATAL_ERROR "pcl_msf: a program with Eigen does not compile:\n${output}")
  endif ()
  file (STRINGS "${program}" layout REGEX "pcl_msf [SHM]=")
  foreach (name IN ITEMS STATIC HEAP MALLOC)
    string (SUBSTRING ${name} 0 1 letter)
    string (REGEX MATCH "pcl_msf ${letter}=0?0?([0-9]+)" found "${layout}")
    set (PCL_MSF_EIGEN_${name} "${CMAKE_MATCH_1}" CACHE INTERNAL "")
  endforeach ()
  set (PCL_MSF_EIGEN_KEY "${key}" CACHE INTERNAL "What the answers belong to")
endfunction ()

pcl_msf_ask_eigen ()
configure_file ("${PROJECT_SOURCE_DIR}/cmake/config.h.in"
  "${PROJECT_BINARY_DIR}/include/pcl_msf/config.h" @ONLY)
