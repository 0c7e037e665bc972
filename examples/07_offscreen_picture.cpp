// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// A picture of the warped cloud in 3-D, on a machine with or without a display.
#include "example_clouds.h"
#include <pcl_msf/io/images.h>
#include <pcl_msf/register_clouds.h>
#include <pcl_msf/visualization/offscreen_renderer.h>
#include <pcl_msf/visualization/result_scenes.h>
#include <pcl_msf/visualization/virtual_display.h>

#include <iostream>

int
main ()
{
  using namespace pcl_msf::visualization;
  const auto registered = pcl_msf::registerClouds (exampleCloud (0), exampleCloud (1));
  if (!registered.converged)
    return 1;
  try {
    OffscreenRenderer renderer; // starts an Xvfb where there is no display
    ResultClouds result;
    result.scene_flow = registered.scene_flow;
    result.reference_color = exampleSequence().frames[0].color;
    PictureStyle style;
    style.size = {640, 480};
    const View view =
        orbitView (boundsOf (result.scene_flow.points), style.size, 25.0, 15.0);
    pcl_msf::io::writeImage (
        "arrows.png",
        renderer.render (resultScene (PictureKind::Arrows, result), view, style));
    std::cout << "arrows.png: displacements, coloured by length\n";
    return 0;
  }
  catch (const DisplayError& error) { // says what to install
    std::cerr << error.what() << "\n";
    return 1;
  }
}
