// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/export.h>
#include <pcl_msf/visualization/scene.h>
#include <pcl_msf/visualization/view.h>

#include <memory>

namespace pcl_msf::visualization {

/** \brief Draws scenes into images, with or without a display (see VirtualDisplay).
 *
 * One VTK window serves all pictures of one object. Not thread-safe: one object in one
 * thread.
 */
class PCL_MSF_EXPORT OffscreenRenderer {
public:
  /** \throws DisplayError when this machine cannot draw */
  OffscreenRenderer();
  ~OffscreenRenderer();
  OffscreenRenderer (const OffscreenRenderer&) = delete;
  OffscreenRenderer&
  operator= (const OffscreenRenderer&) = delete;

  /** \brief Draws a scene. The view is fitted to the style's size (View::resized).
   * \return CV_8UC3 (BGR) \throws InvalidInput for a style that is not valid, an
   * invalid view, or images of a point set that do not fit; DisplayError when OpenGL
   * fails */
  cv::Mat
  render (const Scene& scene, const View& view, const PictureStyle& style = {});

private:
  class Window;
  std::unique_ptr<Window> window_;
};

} // namespace pcl_msf::visualization
