// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/build_compatibility.h>
#include <pcl_msf/export.h>
#include <pcl_msf/parameters.h>
#include <pcl_msf/pinhole_camera.h>

#include <vector>

namespace pcl_msf {

/** \brief One resolution of an RGB-D frame. All images have the same size. */
struct FrameLevel {
  PinholeCamera camera;  ///< of this level, pixels of this level
  cv::Mat intensity;     ///< CV_32FC1, [0, 1], Gaussian-smoothed; empty without colour
  cv::Mat inverse_depth; ///< CV_32FC1, 1 / metres; 0 = no measurement
  cv::Mat normals;       ///< CV_32FC3, unit, towards the camera (z < 0); 0 0 0 = none

  int
  width () const
  {
    return inverse_depth.cols;
  }
  int
  height () const
  {
    return inverse_depth.rows;
  }
};

/** \brief An RGB-D image with its camera, prepared for alignment: smoothed intensity,
 * inverse depth, normals, a pyramid of them, and the noise found in it (section 3.3).
 *
 * Immutable once made; copies share the images; safe to read from many threads.
 */
class PCL_MSF_EXPORT RgbdFrame {
public:
  RgbdFrame() = default;

  /** \param color CV_8UC1, CV_8UC3 (BGR) or CV_32FC1 in [0, 1], highlights above are
   * cut, not finite is black (see normalizeIntensity); empty = geometry only
   * \param depth CV_32FC1, metres; NaN, inf, 0 and negative = no measurement
   * \param camera of both (they are registered to each other)
   * \param normals CV_32FC3 or empty: used in place of computed normals when given
   * \throws InvalidInput for less than 12x12 pixels, at the finest level, too, sizes
   * that differ, no valid depth, intensity in another unit, absurd camera */
  static RgbdFrame
  fromImages (const cv::Mat& color,
              const cv::Mat& depth,
              const PinholeCamera& camera,
              const FrameParameters& parameters = {},
              const cv::Mat& normals = {});

  bool
  empty () const
  {
    return levels_.empty();
  }
  bool
  hasIntensity () const
  {
    return !empty() && !levels_[0].intensity.empty();
  }
  int
  width () const
  {
    return empty() ? 0 : levels_[0].width();
  }
  int
  height () const
  {
    return empty() ? 0 : levels_[0].height();
  }
  const PinholeCamera&
  camera () const
  {
    return levels_.at (0).camera;
  }

  /** \brief Level 0 has the frame's size, each next one half of it. */
  const std::vector<FrameLevel>&
  levels () const
  {
    return levels_;
  }

  /** \brief How often the input was halved: FrameParameters::finest_level. */
  int
  finestLevel () const
  {
    return finest_level_;
  }

  /** \brief The input's camera, in its own pixels, of which the frame's are each
   * 2^finestLevel ()th; pixel 0 is the same. */
  const PinholeCamera&
  inputCamera () const
  {
    return finest_level_ == 0 ? camera() : input_camera_;
  }

  /** \brief The input's inverse depth, CV_32FC1, 1 / metres; 0 = no measurement. */
  const cv::Mat&
  inputInverseDepth () const
  {
    return finest_level_ == 0 ? levels_.at (0).inverse_depth : input_inverse_depth_;
  }

  /** \brief Standard deviation of the input's intensity noise, intensity units; what
   * is halved keeps it, as neighbours err alike. */
  double
  intensityNoise () const
  {
    return intensity_noise_;
  }

  /** \brief Standard deviation of the input's inverse depth, 1 / metres; sigma_z = z^2
   * times this (disparity sensors have one such number for all depths). */
  double
  inverseDepthNoise () const
  {
    return inverse_depth_noise_;
  }

  /** \brief Unsmoothed 8-bit grey image of the frame's size; empty without colour. */
  const cv::Mat&
  gray () const
  {
    return gray_;
  }

  /** \brief Colour as given, CV_8UC3 BGR, for pictures; empty when none was given. */
  const cv::Mat&
  color () const
  {
    return color_;
  }

private:
  std::vector<FrameLevel> levels_;
  PinholeCamera input_camera_; ///< both unused when finest_level_ is 0
  cv::Mat input_inverse_depth_;
  int finest_level_{0};
  cv::Mat gray_;
  cv::Mat color_;
  double intensity_noise_{0.0};
  double inverse_depth_noise_{0.0};
};

} // namespace pcl_msf
