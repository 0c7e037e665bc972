# SPDX-License-Identifier: BSD-3-Clause
# Finds what the project links; a missing package gives one line with its Debian name.

macro (pcl_msf_require package debian_name)
  find_package (${package} QUIET ${ARGN})
  if (NOT ${package}_FOUND)
    message (FATAL_ERROR "pcl_msf needs ${package}: sudo apt-get install ${debian_name}")
  endif ()
endmacro ()

pcl_msf_require (Eigen3 libeigen3-dev)
pcl_msf_require (PCL libpcl-dev COMPONENTS common kdtree search)
pcl_msf_require (Ceres libceres-dev)
pcl_msf_require (OpenCV libopencv-dev COMPONENTS core imgproc video imgcodecs)
pcl_msf_require (Threads libc6-dev)
find_package (OpenCV QUIET COMPONENTS core imgproc video imgcodecs ximgproc
  OPTIONAL_COMPONENTS optflow)
if (NOT OpenCV_ximgproc_FOUND AND NOT TARGET opencv_ximgproc)
  message (FATAL_ERROR
    "pcl_msf needs OpenCV's ximgproc: sudo apt-get install libopencv-contrib-dev")
endif ()

include (PclMsfPlainPcl)
