# SPDX-License-Identifier: BSD-3-Clause
# Settings that all of the project's own targets share; none of them is exported.

function (pcl_msf_target_settings target)
  target_compile_features (${target} PUBLIC cxx_std_17)
  set_target_properties (${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options (${target} PRIVATE -Wall -Wextra)
  if (PCL_MSF_WARNINGS_AS_ERRORS)
    target_compile_options (${target} PRIVATE -Werror)
  endif ()
  if (PCL_MSF_SANITIZE)
    target_compile_options (${target} PRIVATE
      -fsanitize=${PCL_MSF_SANITIZE} -fno-omit-frame-pointer)
    target_link_options (${target} PRIVATE -fsanitize=${PCL_MSF_SANITIZE})
  endif ()
endfunction ()

# pcl_msf_library (name SOURCES ... PUBLIC_LINK ... PRIVATE_LINK ...): a library of the
# project, exported as pcl_msf::<name without pcl_msf_>.
function (pcl_msf_library target)
  cmake_parse_arguments (arg "" "" "SOURCES;PUBLIC_LINK;PRIVATE_LINK" ${ARGN})
  add_library (${target} ${arg_SOURCES})
  pcl_msf_target_settings (${target})
  target_include_directories (${target}
    PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
           $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_include_directories (${target} SYSTEM PUBLIC
    ${PCL_INCLUDE_DIRS} ${OpenCV_INCLUDE_DIRS})
  target_link_libraries (${target}
    PUBLIC ${arg_PUBLIC_LINK} PRIVATE ${arg_PRIVATE_LINK})
  string (REGEX REPLACE "^pcl_msf_" "" export_name ${target})
  set_target_properties (${target} PROPERTIES
    EXPORT_NAME ${export_name} VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR} POSITION_INDEPENDENT_CODE ON)
  add_library (pcl_msf::${export_name} ALIAS ${target})
endfunction ()
