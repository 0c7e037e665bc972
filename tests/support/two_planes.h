// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "support/analytic_scene.h"

namespace pcl_msf {
namespace test {

/** \brief Two slanted planes that move apart. */
inline AnalyticScene
twoPlanes ()
{
  AnalyticScene s;
  s.camera = {45.0, 44.0, 23.0, 19.5};
  s.width = 48;
  s.height = 40;
  s.quads.push_back ({{-2.0, -2.0, 1.7}, {1.95, 0, 0.5}, {0, 4, 0.6}, 0, 0.4});
  s.quads.push_back ({{0.0, -2.0, 2.1}, {3, 0, -0.7}, {0, 4, -0.3}, 1, 2.9});
  s.motions.push_back (
      turnAbout ({-0.7, 0, 2.2}, {0.01, 0.012, -0.02}, {-0.04, 0.01, -0.01}));
  s.motions.push_back (
      turnAbout ({0.8, 0, 1.9}, {-0.01, 0.02, 0.01}, {0.01, 0.03, 0.012}));
  return s;
}

} // namespace test
} // namespace pcl_msf
