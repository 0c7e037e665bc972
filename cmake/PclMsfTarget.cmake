# SPDX-License-Identifier: BSD-3-Clause
# How the project's own targets are made and installed.

set (PCL_MSF_CONFIG_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/pcl_msf")
set (PCL_MSF_SOVERSION ${PROJECT_VERSION_MAJOR})
if (PROJECT_VERSION_MAJOR EQUAL 0) # every 0.x may change the interface
  set (PCL_MSF_SOVERSION 0.${PROJECT_VERSION_MINOR})
endif ()

# Settings that all of the project's targets share; none of them is exported but C++17.
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
    # Eigen changes its allocator under a sanitizer; prebuilt libraries that hand out
    # Eigen matrices have not.
    target_compile_definitions (${target} PRIVATE EIGEN_MALLOC_ALREADY_ALIGNED=1)
  endif ()
endfunction ()

# pcl_msf_library (name SOURCES ... PUBLIC_LINK ... PRIVATE_LINK ...): a library of the
# project, exported as pcl_msf::<name without pcl_msf_>, a component of the package.
function (pcl_msf_library target)
  cmake_parse_arguments (arg "" "" "SOURCES;PUBLIC_LINK;PRIVATE_LINK" ${ARGN})
  add_library (${target} ${arg_SOURCES})
  pcl_msf_target_settings (${target})
  target_include_directories (${target}
    PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
           $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
           $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries (${target}
    PUBLIC ${arg_PUBLIC_LINK} PRIVATE ${arg_PRIVATE_LINK})
  string (REGEX REPLACE "^pcl_msf_" "" export_name ${target})
  set_target_properties (${target} PROPERTIES
    EXPORT_NAME ${export_name} VERSION ${PROJECT_VERSION}
    SOVERSION ${PCL_MSF_SOVERSION} POSITION_INDEPENDENT_CODE ON)
  if (BUILD_SHARED_LIBS) # the components find each other wherever they are installed
    set_target_properties (${target} PROPERTIES INSTALL_RPATH "$ORIGIN")
    if (NOT PCL_MSF_BUILD_TESTS) # which use private parts
      set_target_properties (${target} PROPERTIES
        CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    endif ()
  endif ()
  add_library (pcl_msf::${export_name} ALIAS ${target})
  set_property (GLOBAL APPEND PROPERTY PCL_MSF_LIBRARIES ${target})
  if (PCL_MSF_INSTALL)
    pcl_msf_install_library (${target})
  endif ()
endfunction ()

# One export file per library, so that find_package loads only the components asked for.
function (pcl_msf_install_library target)
  install (TARGETS ${target} EXPORT ${target}_targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install (EXPORT ${target}_targets NAMESPACE pcl_msf::
    FILE ${target}_targets.cmake DESTINATION ${PCL_MSF_CONFIG_DIR})
endfunction ()

# pcl_msf_tool (name SOURCES ... LINK ...): a program that is installed.
function (pcl_msf_tool target)
  cmake_parse_arguments (arg "" "" "SOURCES;LINK" ${ARGN})
  add_executable (${target} ${arg_SOURCES})
  pcl_msf_target_settings (${target})
  target_link_libraries (${target} PRIVATE ${arg_LINK})
  if (BUILD_SHARED_LIBS)
    set_target_properties (${target} PROPERTIES
      INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
  endif ()
  if (PCL_MSF_INSTALL)
    install (TARGETS ${target} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  endif ()
endfunction ()
