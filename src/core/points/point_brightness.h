// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/points/deformation.h"
#include "core/points/isometry.h"
#include "core/surface/surface_texture.h"

#include <cmath>
#include <vector>

namespace pcl_msf {

/** \brief How the brightness of moved points compares with that of their matches.
 *
 * A difference over the target's slope is how far a point must go along the surface to
 * be as bright as it should be: a length, linear in where the point is, like the
 * distance from a plane. What noise and wrong matches leave of it tells its weight. */
class BrightnessComparison {
public:
  /** \brief Compares nothing. */
  BrightnessComparison() = default;

  /** \brief Exposure, noise and weight, by matches.
   * \param surface, texture of the target; must outlive this
   * \param reach length up to which differences may be distances
   * \param weight of a squared difference without noise \param outlying deviations */
  BrightnessComparison (const MovedPoints& moved,
                        const std::vector<PointPair>& matches,
                        const Surface& surface,
                        const SurfaceTexture& texture,
                        double reach,
                        double weight,
                        double outlying);

  /** \brief Does it tell anything? */
  bool
  used () const
  {
    return weight_ > 0.0;
  }

  /** \brief Is the brightness of a moved point and of its match known? */
  bool
  knows (const MovedPoints& moved, int i, int j) const;

  /** \brief Along the surface at a match, how the difference grows with the point's
   * place. */
  Eigen::Vector3d
  slope (int j) const
  {
    return texture_->gradient[j].cast<double>() / texture_->slope;
  }

  /** \brief Of a point and its match; a length. */
  double
  difference (const MovedPoints& moved, int i, int j) const;

  /** \brief Weight of its square beside that of a distance, robust. */
  double
  weight (double difference) const
  {
    const double g = scale_ * scale_ / (scale_ * scale_ + difference * difference);
    return weight_ * g * g;
  }

  /** \brief A difference as a distance of the same weight. */
  double
  length (double difference) const
  {
    return std::sqrt (weight_) * std::abs (difference);
  }

  /** \brief Between points and their matches, [-1, 1]. */
  double
  correlation () const
  {
    return correlation_;
  }
  double
  gain () const
  {
    return gain_;
  }
  double
  offset () const
  {
    return offset_;
  }

private:
  bool
  fitExposure (const MovedPoints& moved, const std::vector<PointPair>& matches);

  const Surface* surface_{nullptr};
  const SurfaceTexture* texture_{nullptr};
  double gain_{1.0}; ///< target = gain * source + offset
  double offset_{0.0};
  double correlation_{0.0};
  double weight_{0.0};
  double scale_{1.0};
};

} // namespace pcl_msf
