# SPDX-License-Identifier: BSD-3-Clause
# The installed package: headers, find_package and pkg-config files, documents.
include (CMakePackageConfigHelpers)

set (package_source_dir "${CMAKE_CURRENT_LIST_DIR}")
get_property (PCL_MSF_LIBRARIES GLOBAL PROPERTY PCL_MSF_LIBRARIES)

install (DIRECTORY "${PROJECT_SOURCE_DIR}/include/pcl_msf"
  "${PROJECT_BINARY_DIR}/include/pcl_msf" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install (FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/README.md"
  "${PROJECT_SOURCE_DIR}/CHANGELOG.md" DESTINATION ${CMAKE_INSTALL_DOCDIR})

configure_package_config_file (
  "${package_source_dir}/pcl_msf-config.cmake.in" pcl_msf-config.cmake
  INSTALL_DESTINATION ${PCL_MSF_CONFIG_DIR}
  PATH_VARS CMAKE_INSTALL_INCLUDEDIR
  NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file (pcl_msf-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install (FILES
  "${CMAKE_CURRENT_BINARY_DIR}/pcl_msf-config.cmake"
  "${CMAKE_CURRENT_BINARY_DIR}/pcl_msf-config-version.cmake"
  "${package_source_dir}/PclMsfPlainPcl.cmake"
  "${package_source_dir}/PclMsfVtk.cmake"
  DESTINATION ${PCL_MSF_CONFIG_DIR})

# A static library does not bring its own dependencies along: pkg-config has to name
# them in Libs, a shared one keeps them private.
set (pc_dependencies "-lopencv_features2d -lopencv_video -lopencv_imgproc -lceres -lglog -pthread")
if (PCL_MSF_XIMGPROC AND NOT PCL_MSF_XIMGPROC_FILES)
  string (PREPEND pc_dependencies "-lopencv_ximgproc ")
endif ()
if (BUILD_SHARED_LIBS)
  set (pc_libs_private "${pc_dependencies}")
  set (pc_dependencies "")
endif ()
file (RELATIVE_PATH pc_prefix "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string (REGEX REPLACE "/$" "" pc_prefix "${pc_prefix}")
configure_file ("${package_source_dir}/pcl_msf.pc.in" pcl_msf.pc @ONLY)
install (FILES "${CMAKE_CURRENT_BINARY_DIR}/pcl_msf.pc"
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
