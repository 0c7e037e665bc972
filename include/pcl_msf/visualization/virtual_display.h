// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace pcl_msf::visualization {

/** \brief A picture that cannot be made on this machine; what() is one line that says
 * what is missing and what to install. */
class PCL_MSF_EXPORT DisplayError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/** \brief Why the X display that DISPLAY names cannot show OpenGL; empty when it can.
 * \param[out] connection that the check has opened; hold it until VTK has drawn, since
 * some servers start anew when their last client leaves; null = it is closed */
PCL_MSF_EXPORT std::string
displayProblem (std::shared_ptr<void>* connection = nullptr);

/** \brief A display for as long as the object lives: the one that DISPLAY names when
 * that works, an Xvfb of its own on a free display number otherwise.
 *
 * VTK built for X can only draw on an X display and ends the process without one. Make
 * this guard before the first VTK window and keep it longer than the last. With a VTK
 * that needs no X (EGL, OSMesa) the guard does nothing.
 *
 * Xvfb ends with the guard. It also ends with the process, whatever ends that (the
 * kernel sends SIGTERM when the thread that made the guard is gone, so that thread has
 * to live as long as the guard), and it is in a process group of its own, so that
 * Ctrl-C reaches the program first. DISPLAY is set for the process meanwhile: make and
 * destroy guards while no other thread reads or changes the environment.
 */
class PCL_MSF_EXPORT VirtualDisplay {
public:
  /** \throws DisplayError when there is no display and none can be started */
  VirtualDisplay();
  ~VirtualDisplay();
  VirtualDisplay (const VirtualDisplay&) = delete;
  VirtualDisplay&
  operator= (const VirtualDisplay&) = delete;

  /** \brief Was a display started (true), or one found (false)? */
  bool
  started () const;

  /** \brief What DISPLAY is now, e.g. ":3"; empty when none is needed. */
  std::string
  name () const;

private:
  class Server;
  std::unique_ptr<Server> server_;
  std::shared_ptr<void> connection_; ///< to a display that was there
};

} // namespace pcl_msf::visualization
