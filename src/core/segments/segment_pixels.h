// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <opencv2/core.hpp>

#include "core/base/tuning/segment_tuning.h"
#include "core/frame/brightness_change.h"
#include <pcl_msf/rgbd_frame.h>

#include <vector>

namespace pcl_msf {

/** \brief Pixels of the full resolution that are worth one independent residual. */
struct CorrelationAreas {
  double brightness{1.0};
  double icp{1.0};
};

/** \brief Standard deviations that the data terms are measured in. */
struct NoiseModel {
  double intensity{0.02};       ///< intensity units
  double displacement{0.15};    ///< pixels: what the motion model leaves unexplained
  double inverse_depth{0.001};  ///< 1 / metres
  double relative_depth{0.001}; ///< share of the inverse depth, added to it
  CorrelationAreas areas{};     ///< see measureCorrelationAreas
};

/** \brief The reference points of one level, grouped by segment: Omega_k of Eq. 6.
 *
 * Structure of arrays in float, in raster order within a segment; the kernels run over
 * ranges of it, in groups that may end among the next segment's points: kPadding zeros
 * follow the last point in the arrays of float. Scales are one over the standard
 * deviation of a residual; 0 switches a point's residual off (no intensity, no normal).
 */
struct SegmentPixels {
  static constexpr int kPadding = 15;

  std::vector<int> begin;        ///< K + 1 offsets
  std::vector<int> pixel;        ///< y * width + x in the level's image
  std::vector<float> x, y, z;    ///< metres
  std::vector<float> intensity;  ///< [0, 1]
  std::vector<float> nx, ny, nz; ///< normal
  std::vector<float> brightness_scale;
  std::vector<float> icp_scale;
  std::vector<float> depth_tolerance;    ///< of the z-test, 1 / metres
  float tolerance_sigmas{1.0f};          ///< standard deviations of the noise in it
  std::vector<Eigen::Vector3d> centroid; ///< metres; of the level's points
  std::vector<Eigen::Matrix3d> spread;   ///< square metres; their second moments about
                                         ///< the centroid
  std::vector<int> pixels_per_point; ///< per segment: pixels of the level that a point
                                     ///< stands for, and counts as
  int brightness_count{0};           ///< pixels of points with intensity
  int icp_count{0};                  ///< likewise with a normal
  CorrelationAreas areas;            ///< of the residuals, pixels of level 0
  int pixel_area{1};                 ///< pixels of level 0 in one of the level

  int
  segments () const
  {
    return static_cast<int> (begin.size()) - 1;
  }
  int
  size (int segment) const
  {
    return begin[segment + 1] - begin[segment];
  }
  /** \brief Pixels of the level that a segment's points stand for. */
  int
  pixels (int segment) const
  {
    return pixels_per_point[segment] * size (segment);
  }
};

/** \brief How points are made from a level. */
struct PointOptions {
  NoiseModel noise;
  double relative_tolerance{0.01}; ///< share of the inverse depth that the z-test
                                   ///< allows, besides the noise and what a pixel
                                   ///< makes on a slanted surface
  BrightnessChange change;         ///< applied to the reference's intensity
  int max_per_segment{0};          ///< 0 = all; else evenly spaced samples; more when
                                   ///< so few segments would have too few in all
  int threads{1};
  int level{0};
  int thinning{1}; ///< pixels of the level that a point stands for at the most: 1, 2
                   ///< or 4, in a pattern; not of samples
  PixelTuning tuning{};
};

/** \brief Groups a level's points. \param labels of the level's size, -1 = none */
SegmentPixels
groupPixels (const FrameLevel& level,
             const cv::Mat& labels,
             int segments,
             const PointOptions& options);

/** \brief Where an image of some size shows a pixel: -1 to 1 over its width, height. */
inline cv::Point2f
placeInImage (int u, int v, cv::Size size)
{
  return {static_cast<float> (2 * u + 1) / static_cast<float> (size.width) - 1.0f,
          static_cast<float> (2 * v + 1) / static_cast<float> (size.height) - 1.0f};
}

/** \brief Labels of the next coarser level: those of pixels (2 i, 2 j); a pixel without
 * label takes one of its neighbours'. */
cv::Mat
halveLabels (const cv::Mat& labels);

} // namespace pcl_msf
