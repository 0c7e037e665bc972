# SPDX-License-Identifier: BSD-3-Clause
# The installed package: headers, find_package and pkg-config files, Debian package.
include (CMakePackageConfigHelpers)

set (package_source_dir "${CMAKE_CURRENT_LIST_DIR}")
get_property (PCL_MSF_LIBRARIES GLOBAL PROPERTY PCL_MSF_LIBRARIES)

install (DIRECTORY "${PROJECT_SOURCE_DIR}/include/pcl_msf"
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install (FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION ${CMAKE_INSTALL_DOCDIR})

configure_package_config_file (
  "${package_source_dir}/pcl_msf-config.cmake.in" pcl_msf-config.cmake
  INSTALL_DESTINATION ${PCL_MSF_CONFIG_DIR} NO_SET_AND_CHECK_MACRO)
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
set (pc_dependencies "-lopencv_ximgproc -lopencv_video -lopencv_imgproc -lceres \
-lglog -lpcl_features -pthread")
if (BUILD_SHARED_LIBS)
  set (pc_libs_private "${pc_dependencies}")
  set (pc_dependencies "")
endif ()
file (RELATIVE_PATH pc_prefix "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string (REGEX REPLACE "/$" "" pc_prefix "${pc_prefix}")
configure_file ("${package_source_dir}/pcl_msf.pc.in" pcl_msf.pc @ONLY)
install (FILES "${CMAKE_CURRENT_BINARY_DIR}/pcl_msf.pc"
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

set (CPACK_GENERATOR DEB)
set (CPACK_PACKAGE_NAME libpcl-msf-dev)
set (CPACK_PACKAGE_CONTACT "The pcl_msf authors")
set (CPACK_PACKAGE_DESCRIPTION_SUMMARY
  "Piecewise-rigid RGB-D scene flow as a Point Cloud Library registration")
set (CPACK_PACKAGING_INSTALL_PREFIX /usr)
set (CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set (CPACK_STRIP_FILES ON)
set (CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set (CPACK_DEBIAN_PACKAGE_SECTION libdevel)
set (CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set (CPACK_DEBIAN_PACKAGE_DEPENDS
  "libpcl-dev, libceres-dev, libopencv-dev, libopencv-contrib-dev")
if (TARGET pcl_msf_visualization)
  set (CPACK_DEBIAN_PACKAGE_RECOMMENDS "libvtk9-dev, xvfb")
endif ()
include (CPack)
