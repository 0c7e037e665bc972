# SPDX-License-Identifier: BSD-3-Clause
# Finds what the project links; a missing package gives one line with its remedy.

macro (pcl_msf_require package debian_name)
  find_package (${package} QUIET ${ARGN})
  if (NOT ${package}_FOUND)
    message (FATAL_ERROR "pcl_msf needs ${package}: install it, or name its place in "
      "CMAKE_PREFIX_PATH (Debian: ${debian_name})")
  endif ()
endmacro ()

pcl_msf_require (Eigen3 libeigen3-dev)
pcl_msf_require (PCL libpcl-dev COMPONENTS common kdtree search)
pcl_msf_require (Ceres libceres-dev)
pcl_msf_require (Threads libc6-dev)
pcl_msf_require (OpenCV libopencv-dev COMPONENTS core features2d imgproc video imgcodecs
  OPTIONAL_COMPONENTS ximgproc optflow)
# Header-only, and seen by the project's own sources alone.
pcl_msf_require (nlohmann_json nlohmann-json3-dev)
if (PCL_MSF_BUILD_EXAMPLES)
  pcl_msf_require (CLI11 libcli11-dev)
endif ()

set (PCL_MSF_XIMGPROC "") # the target
set (PCL_MSF_XIMGPROC_NAME "")
if (TARGET opencv_ximgproc AND PCL_MSF_WITH_XIMGPROC)
  set (PCL_MSF_XIMGPROC opencv_ximgproc)
  set (PCL_MSF_XIMGPROC_NAME ximgproc)
elseif (PCL_MSF_WITH_XIMGPROC AND NOT PCL_MSF_WITH_XIMGPROC STREQUAL "AUTO")
  message (FATAL_ERROR "pcl_msf needs OpenCV's ximgproc: install OpenCV's contrib "
    "modules (Debian: libopencv-contrib-dev)")
else ()
  message (STATUS "pcl_msf is built without OpenCV's ximgproc (Debian: "
    "libopencv-contrib-dev): no Felzenszwalb and no SLIC segmentation")
endif ()

include (PclMsfLazyLibraries)
pcl_msf_lazy_library (imgcodecs _ZN2cv8imdecodeERKNS_11_InputArrayEi
  _ZN2cv8imencodeERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEERKNS_11_InputArrayERSt6vectorIhSaIhEERKSB_IiSaIiEE)
if (PCL_MSF_XIMGPROC)
  pcl_msf_lazy_library (ximgproc _ZN2cv8ximgproc12segmentation23createGraphSegmentationEdfi
    _ZN2cv8ximgproc20createSuperpixelSLICERKNS_11_InputArrayEiif)
endif ()
if (TARGET opencv_optflow)
  pcl_msf_lazy_library (optflow _ZN2cv7optflow22createOptFlow_DualTVL1Ev)
endif ()
# PCL's io needs libpng, too. Without it OpenCV decodes PNG files.
find_package (PNG QUIET)
set (PCL_MSF_PNG "")
if (PNG_FOUND)
  set (PCL_MSF_PNG PNG::PNG)
endif ()

if (PCL_MSF_BUILD_VISUALIZATION)
  include (PclMsfVtk)
  if (PCL_MSF_VTK_PROBLEM AND NOT PCL_MSF_BUILD_VISUALIZATION STREQUAL "AUTO")
    message (FATAL_ERROR "pcl_msf visualization: ${PCL_MSF_VTK_PROBLEM}")
  elseif (PCL_MSF_VTK_PROBLEM)
    message (STATUS "pcl_msf is built without visualization: ${PCL_MSF_VTK_PROBLEM}")
  endif ()
endif ()

set (pcl_msf_plain_pcl io)
if (PCL_MSF_BUILD_EXAMPLES OR PCL_MSF_BUILD_TESTS)
  list (APPEND pcl_msf_plain_pcl features filters registration segmentation)
  if (PCL_MSF_VTK_TARGETS)
    list (APPEND pcl_msf_plain_pcl visualization)
  endif ()
endif ()
include (PclMsfPlainPcl)
if (pcl_msf_plain_pcl_missing)
  message (FATAL_ERROR "pcl_msf needs PCL's libraries ${pcl_msf_plain_pcl_missing}: "
    "install them beside pcl_common (Debian: libpcl-dev)")
endif ()
pcl_msf_lazy_pcl_library (io
  _ZN3pcl2io4loadERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEERNS_14PCLPointCloud2E
  _ZN3pcl13lzfDecompressEPKvjPvj)
