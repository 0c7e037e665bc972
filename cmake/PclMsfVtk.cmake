# SPDX-License-Identifier: BSD-3-Clause
# VTK and what else the component visualization needs. The installed config includes this
# file, too. Sets PCL_MSF_VTK_TARGETS when all is there, PCL_MSF_VTK_PROBLEM when not.

set (PCL_MSF_VTK_TARGETS "")
set (PCL_MSF_VTK_PROBLEM "")
get_property (pcl_msf_enabled_languages GLOBAL PROPERTY ENABLED_LANGUAGES)
if (NOT "C" IN_LIST pcl_msf_enabled_languages) # Debian's VTK looks for MPI in C
  set (PCL_MSF_VTK_PROBLEM
    "VTK needs a project with the language C: project (<name> LANGUAGES C CXX)")
  return ()
endif ()

set (pcl_msf_vtk_modules
  CommonCore CommonDataModel RenderingCore RenderingFreeType RenderingOpenGL2)
find_package (VTK 9 QUIET COMPONENTS
  ${pcl_msf_vtk_modules} InteractionStyle InteractionWidgets RenderingLOD)
find_package (X11 QUIET)
find_package (OpenGL QUIET COMPONENTS OpenGL GLX)
find_package (OpenCV QUIET COMPONENTS core imgproc video imgcodecs videoio)
if (NOT VTK_FOUND)
  set (PCL_MSF_VTK_PROBLEM "VTK 9 is missing: install it, or name its place in CMAKE_PREFIX_PATH (Debian: libvtk9-dev)")
elseif (NOT X11_FOUND OR NOT OpenGL_GLX_FOUND)
  set (PCL_MSF_VTK_PROBLEM
    "X11 or GLX is missing: install their headers (Debian: libx11-dev libgl-dev)")
elseif (NOT TARGET opencv_videoio)
  set (PCL_MSF_VTK_PROBLEM
    "OpenCV's videoio is missing: install OpenCV with it (Debian: libopencv-dev)")
else ()
  list (TRANSFORM pcl_msf_vtk_modules PREPEND "VTK::" OUTPUT_VARIABLE PCL_MSF_VTK_TARGETS)
endif ()
