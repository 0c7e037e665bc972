// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/data/data_term.h"
#include "core/segments/segment_graph.h"
#include "support/analytic_scene.h"
#include "support/points.h"

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace pcl_msf {
namespace test {

/** \brief Displacement of the wall at a column of the image. */
struct WallShift {
  double down;   ///< pixels
  double nearer; ///< metres
};

/** \brief A wall in tiles of 20 pixels whose columns slide down and come nearer by
 * amounts that depend on the column: soft where they change gradually. Each tile has
 * the motion of its middle. */
class BendingWall {
public:
  static constexpr int kTile = 20;
  static constexpr double kDepth = 2.4; ///< metres

  BendingWall (int columns, int rows, const std::function<WallShift (double)>& shift)
  : columns_ (columns)
  {
    const int width = kTile * columns;
    const int height = kTile * rows;
    camera = {150.0, 150.0, 0.5 * (width - 1), 0.5 * (height - 1)};
    labels = cv::Mat (height, width, CV_32SC1);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        labels.at<int> (y, x) = y / kTile * columns + x / kTile;
    for (int k = 0; k < columns * rows; ++k)
      poses_.push_back (poseOf (shift (middle (k % columns))));
    const auto still = [] (double) { return WallShift{0.0, 0.0}; };
    const FrameLevel reference = frame (still).levels()[0];
    NoiseModel noise;
    noise.intensity = 0.01;
    noise.displacement = 0.1;
    pixels = pointsOf (reference, labels, columns * rows, noise, 0.01);
    texture_ = std::make_unique<Texture> (frame (shift).levels()[0]);
    links = linkNearestCentroids (pixels.centroid, 4);
  }

  /** \brief One body per tile, all links at weight 0. */
  MotionState
  truth () const
  {
    MotionState state = MotionState::fromSegments (poses_, links.size());
    state.weights.assign (links.size(), 0.0);
    return state;
  }

  DataTerm
  data (const MotionState& state, int threads = 1) const
  {
    DataTerm result (pixels, *texture_, makeRules ({}, pixels, {}), threads);
    result.sweep (state, DataTerm::Pass::Linearize);
    return result;
  }

  /** \brief The tile at a column and row. */
  int
  tile (int column, int row) const
  {
    return row * columns_ + column;
  }

  PinholeCamera camera;
  cv::Mat labels;
  SegmentPixels pixels;
  std::vector<SegmentLink> links;

private:
  static double
  middle (int column)
  {
    return (column + 0.5) * kTile - 0.5;
  }

  RigidPose
  poseOf (const WallShift& shift) const
  {
    return turnAbout (
        {0, 0, 0}, {0, 0, 0}, {0, shift.down * kDepth / camera.fy, -shift.nearer});
  }

  /** Coming nearer leaves the picture as it is: tests use one of both at a time. */
  RgbdFrame
  frame (const std::function<WallShift (double)>& shift) const
  {
    const double metre = kDepth / camera.fx;
    const cv::Mat color = image (labels.cols, labels.rows, [&] (int x, int y) {
      return texture (metre * x, metre * (y - shift (x).down), 0.3);
    });
    const cv::Mat depth = image (labels.cols, labels.rows, [&] (int x, int) {
      return kDepth - shift (x).nearer;
    });
    return RgbdFrame::fromImages (color, depth, camera, {});
  }

  int columns_;
  std::vector<RigidPose> poses_;
  std::unique_ptr<Texture> texture_;
};

/** \brief 0 up to the first column, 1 from the last, growing between. */
inline double
ramp (double x, double first, double last)
{
  return std::min (1.0, std::max (0.0, (x - first) / (last - first)));
}

} // namespace test
} // namespace pcl_msf
