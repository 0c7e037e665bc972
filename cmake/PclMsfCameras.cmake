# SPDX-License-Identifier: BSD-3-Clause
# Live cameras that PCL has a grabber for.

# Lets a target use those that are there: PCL_MSF_HAS_OPENNI2, PCL_MSF_HAS_REALSENSE2.
function (pcl_msf_add_cameras target)
  find_file (PCL_MSF_PCL_CONFIG pcl/pcl_config.h HINTS ${PCL_INCLUDE_DIRS})
  find_path (PCL_MSF_OPENNI2_INCLUDE_DIR OpenNI.h PATH_SUFFIXES openni2)
  find_file (PCL_MSF_REALSENSE2_GRABBER pcl/io/real_sense_2_grabber.h
    HINTS ${PCL_INCLUDE_DIRS})
  mark_as_advanced (
    PCL_MSF_PCL_CONFIG PCL_MSF_OPENNI2_INCLUDE_DIR PCL_MSF_REALSENSE2_GRABBER)
  set (openni2 "")
  if (PCL_MSF_PCL_CONFIG AND PCL_MSF_OPENNI2_INCLUDE_DIR)
    file (STRINGS ${PCL_MSF_PCL_CONFIG} openni2 REGEX "^#define HAVE_OPENNI2")
  endif ()
  if (openni2)
    target_include_directories (${target} SYSTEM PRIVATE ${PCL_MSF_OPENNI2_INCLUDE_DIR})
    target_compile_definitions (${target} PRIVATE PCL_MSF_HAS_OPENNI2)
  endif ()
  if (PCL_MSF_REALSENSE2_GRABBER)
    find_package (realsense2 QUIET)
  endif ()
  if (TARGET realsense2::realsense2)
    target_link_libraries (${target} PRIVATE realsense2::realsense2)
    target_compile_definitions (${target} PRIVATE PCL_MSF_HAS_REALSENSE2)
  endif ()
endfunction ()
