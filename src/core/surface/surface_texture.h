// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/surface/surface.h"

#include <vector>

namespace pcl_msf {

/** \brief Brightness of the points of a surface as planes fitted around each tell it.
 * Its unit is that of what came in. */
struct SurfaceTexture {
  std::vector<float> value; ///< per point, NaN = unknown; empty = there is none
  std::vector<Eigen::Vector3f> gradient; ///< per unit of length, along the surface
  double slope{0.0}; ///< root mean square of the gradients, without what noise adds
  double trust{0.0}; ///< share of the squared gradients that is no noise, [0, 1]

  bool
  varies () const
  {
    return slope > 0.0;
  }
};

/** \brief Fits a texture.
 * \param brightness per point, NaN = unknown; empty = there is none
 * \param radius of the neighbourhoods
 * \param most neighbours of a point, the nearest */
SurfaceTexture
fitTexture (const Surface& surface,
            const std::vector<float>& brightness,
            double radius,
            int most,
            int threads);

/** \brief The mean brightness of the points that are nearest to each chosen one, NaN
 * where none of them is known. \param brightness per point of the surface */
std::vector<float>
meanBrightness (const Surface& surface,
                const std::vector<float>& brightness,
                const std::vector<int>& chosen,
                int threads);

} // namespace pcl_msf
