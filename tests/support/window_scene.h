// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/energy/energy.h"
#include "support/analytic_scene.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace pcl_msf {
namespace test {

/** \brief The views of a scene whose bodies repeat their motion from frame to frame:
 * frame k shows it after k motions. */
inline std::vector<View>
renderWindow (const AnalyticScene& scene, int frames)
{
  std::vector<View> views{scene.render (false)};
  AnalyticScene moved = scene;
  for (int k = 1; k < frames; ++k) {
    for (std::size_t b = 0; b < scene.motions.size(); ++b)
      moved.motions[b] =
          k == 1 ? scene.motions[b] : scene.motions[b] * moved.motions[b];
    views.push_back (moved.render (true));
  }
  return views;
}

/** \brief A body's motion between two frames of such a window. */
inline RigidPose
motionBetween (const AnalyticScene& scene, int body, int from, int to)
{
  RigidPose pose;
  for (int k = 0; k < std::abs (to - from); ++k)
    pose = scene.motions[body] * pose;
  return to >= from ? pose : pose.inverse();
}

/** \brief A window of frames on one level with true segments, for tests of its energy.
 */
struct EnergyWindow {
  AnalyticScene scene;
  std::vector<RgbdFrame> frames;
  std::vector<cv::Mat> labels;
  FramePairs pairs;
  WindowScene window;
  WindowState state;

  EnergyWindow (const AnalyticScene& analytic, int count, int reference)
  : scene (analytic), pairs (count, reference), window{frames, pairs, 2, 1}
  {
    window.tuning.data.finest_thinning = 1;
    window.tuning.data.least_thinned = 1; // small as it is, where a test has it thinned
    FrameParameters plain;
    plain.smoothing_sigma = 0.0;
    plain.max_levels = 1;
    for (const View& view : renderWindow (scene, count)) {
      frames.push_back (scene.frame (view, plain));
      cv::Mat label = view.body.clone();
      label.setTo (-1, label > 1);
      labels.push_back (label);
    }
    for (int p = 0; p < pairs.count(); ++p)
      window.used.push_back (p);
    PointOptions options;
    const SegmentPixels points =
        groupPixels (frames[reference].levels()[0], labels[reference], 2, options);
    window.centroids = points.centroid;
    const Eigen::Vector3d& a = points.centroid[0];
    const Eigen::Vector3d& b = points.centroid[1];
    window.links.push_back ({0, 1, 0.5 * (a + b), 0.5 * (a - b).norm()});
    state.body_of = {0, 1};
    state.weights = {0.8};
    for (const FramePairs::Pair& pair : pairs.all())
      state.poses.push_back ({motionBetween (scene, 0, pair.from, pair.to),
                              motionBetween (scene, 1, pair.from, pair.to)});
  }
  EnergyWindow (const EnergyWindow&) = delete;
};

} // namespace test
} // namespace pcl_msf
