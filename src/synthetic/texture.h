// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <synthetic/lattice_noise.h>

namespace pcl_msf::synthetic {

/** \brief What is drawn below the noise. */
enum class Pattern {
  Plain,
  Patches, ///< two tones with soft-edged, irregular borders
  Tiles,   ///< a grid of joints, tiles of slightly different tone
  Stripes  ///< bands along the second axis
};

/** \brief Surface colour as a function of the place on the surface: fixed to it, and
 * with detail down to whatever size a pixel has there. */
struct Texture {
  Eigen::Vector3f color{128.0f, 128.0f, 128.0f}; ///< BGR, 0 .. 255
  Eigen::Vector3f second{90.0f, 90.0f, 90.0f};   ///< BGR of patches, joints, stripes
  Pattern pattern{Pattern::Plain};
  float pattern_size{0.2f}; ///< metres
  float contrast{0.22f};    ///< rms of the noise, relative
  float coarsest{0.25f};    ///< cell of the first octave of noise, metres
  float finest{0.0f};       ///< no octaves with smaller cells, metres
  Eigen::Vector3f offset{0.0f, 0.0f, 0.0f}; ///< tells equal textures apart, metres
};

/** \brief BGR at a surface point.
 * \param place material coordinates, metres
 * \param normal of the surface there, unit length, material coordinates
 * \param footprint size of a pixel on the surface, metres: nothing finer is drawn */
Eigen::Vector3f
textureColor (const Texture& texture,
              const LatticeNoise& noise,
              const Eigen::Vector3f& place,
              const Eigen::Vector3f& normal,
              float footprint);

} // namespace pcl_msf::synthetic
