// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "support/two_bodies.h"

#include <cmath>

namespace pcl_msf {
namespace test {

constexpr int kPlate = 40; // pixels along a side

/** \brief Four by three plates of 40 pixels, each with a motion of its own. */
inline AnalyticScene
loosePlates ()
{
  AnalyticScene s;
  for (int i = 0; i < 12; ++i) {
    const double x = 0.64 * (i % 4) - 1.28;
    const double y = 0.64 * (i / 4) - 0.96;
    s.quads.push_back ({{x, y, 2.4}, {0.64, 0, 0}, {0, 0.64, 0}, i, 0.5 + 1.3 * i});
    const double a = 2.4 * i;
    s.motions.push_back (turnAbout ({x + 0.3, y + 0.3, 2.4},
                                    {0, 0, 0.01 * std::cos (1.7 * i)},
                                    {0.05 * std::cos (a), 0.05 * std::sin (a), 0}));
  }
  return s;
}

/** \brief The loose plates, of which two move as one. */
inline AnalyticScene
loosePlatesButTwo (int a, int b)
{
  AnalyticScene s = loosePlates();
  s.motions[b] = s.motions[a];
  return s;
}

} // namespace test
} // namespace pcl_msf
