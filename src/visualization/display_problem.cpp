// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <GL/glx.h>
#include <pcl_msf/visualization/virtual_display.h>
#include <X11/Xlib.h>

#include <cstdlib>
#include <memory>

namespace pcl_msf::visualization {

std::string
displayProblem (std::shared_ptr<void>* connection)
{
  const char* name = std::getenv ("DISPLAY");
  if (name == nullptr || *name == '\0')
    return "no display (DISPLAY is not set)";
  Display* const opened = XOpenDisplay (nullptr);
  if (opened == nullptr)
    return std::string ("the display ") + name + " cannot be opened";
  const std::shared_ptr<Display> display (opened, XCloseDisplay);
  int event = 0;
  int error = 0;
  const char* const mesa = "; install Mesa's drivers (Debian: libgl1-mesa-dri)";
  if (glXQueryExtension (display.get(), &error, &event) == 0)
    return std::string ("the display ") + name + " has no OpenGL" + mesa;
  const int wanted[] = {GLX_RENDER_TYPE, GLX_RGBA_BIT, GLX_DEPTH_SIZE, 16, 0};
  int count = 0;
  GLXFBConfig* found =
      glXChooseFBConfig (display.get(), DefaultScreen (display.get()), wanted, &count);
  if (found != nullptr)
    XFree (found);
  if (count == 0)
    return std::string ("the display ") + name + " has no OpenGL with depth" + mesa;
  if (connection != nullptr)
    *connection = display;
  return {};
}

} // namespace pcl_msf::visualization
