# SPDX-License-Identifier: BSD-3-Clause
# The Debian package that cpack makes.

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
set (CPACK_DEBIAN_PACKAGE_DEPENDS "libpcl-dev, libceres-dev, libopencv-dev")
if (PCL_MSF_XIMGPROC)
  string (APPEND CPACK_DEBIAN_PACKAGE_DEPENDS ", libopencv-contrib-dev")
endif ()
if (TARGET pcl_msf_visualization)
  set (CPACK_DEBIAN_PACKAGE_RECOMMENDS "libvtk9-dev, xvfb")
endif ()
include (CPack)
