// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/data/pair_terms.h"
#include "core/segments/segment_graph.h"
#include "support/analytic_scene.h"
#include "support/points.h"

#include <memory>
#include <set>
#include <vector>

namespace pcl_msf {
namespace test {

/** \brief Tiles of a scene with the data term that they are judged by. */
class TiledScene {
public:
  explicit TiledScene (AnalyticScene scene, int side = 20) : scene_ (std::move (scene))
  {
    const View reference = scene_.render (false);
    const int columns = (scene_.width + side - 1) / side;
    const int rows = (scene_.height + side - 1) / side;
    cv::Mat labels (scene_.height, scene_.width, CV_32SC1);
    body_of_.assign (columns * rows, -1);
    for (int y = 0; y < labels.rows; ++y)
      for (int x = 0; x < labels.cols; ++x) {
        const int tile = y / side * columns + x / side;
        labels.at<int> (y, x) = tile;
        body_of_[tile] = reference.body.at<int> (y, x);
      }
    NoiseModel noise;
    noise.intensity = 0.01;
    noise.displacement = 0.1;
    pixels_ = pointsOf (
        scene_.frame (reference).levels()[0], labels, columns * rows, noise, 0.01);
    texture_ =
        std::make_unique<Texture> (scene_.frame (scene_.render (true)).levels()[0]);
    links_ = linkNearestCentroids (pixels_.centroid, 6);
  }

  /** \brief One body per segment, each at its true motion. */
  MotionState
  truth () const
  {
    std::vector<RigidPose> poses;
    for (const int body : body_of_)
      poses.push_back (scene_.motions[body]);
    return MotionState::fromSegments (poses, links_.size());
  }

  /** \brief Two bodies that hold the right segments. */
  MotionState
  solved () const
  {
    MotionState state = truth();
    state.body_of = body_of_;
    state.poses = scene_.motions;
    return state;
  }

  DataTerm
  data (int threads = 1) const
  {
    return DataTerm (pixels_, *texture_, makeRules ({}, pixels_, {}), threads);
  }

  /** \brief The one pair, as the steps that form bodies see it. */
  std::vector<PairTerms>
  terms (const DataTerm& data) const
  {
    return {{0, &data, &data, residualScale()}};
  }

  /** \brief Energy times this = sum of squared standard deviations, halved. */
  double
  residualScale () const
  {
    return 0.5 * (pixels_.brightness_count + pixels_.icp_count);
  }

  SegmentPixels&
  pixels ()
  {
    return pixels_;
  }
  const std::vector<SegmentLink>&
  links () const
  {
    return links_;
  }
  const std::vector<int>&
  bodyOf () const
  {
    return body_of_;
  }

private:
  AnalyticScene scene_;
  std::vector<int> body_of_; ///< the true one, per segment
  SegmentPixels pixels_;
  std::unique_ptr<Texture> texture_;
  std::vector<SegmentLink> links_;
};

/** \brief A folded wall whose halves, four tiles wide each, move apart. */
inline AnalyticScene
foldedWall ()
{
  AnalyticScene s;
  // The fold is at pixel 79.5, between two tiles.
  s.quads.push_back ({{-6.0, -4.0, 3.8}, {6.0, 0, -1.6}, {0, 8, 0.3}, 0, 0.7});
  s.quads.push_back ({{0.0, -4.0, 2.2}, {6.0, 0, 1.6}, {0, 8, 0.3}, 1, 2.2});
  s.motions.push_back (
      turnAbout ({-0.8, 0, 2.5}, {0.005, 0.01, 0.01}, {-0.05, 0.01, 0}));
  s.motions.push_back (
      turnAbout ({0.8, 0, 2.5}, {-0.005, 0.01, -0.012}, {0.04, 0.03, 0.02}));
  return s;
}

/** \brief Do two partitions of the segments agree, whatever their numbers? */
inline bool
samePartition (const std::vector<int>& a, const std::vector<int>& b)
{
  std::set<std::pair<int, int>> pairs;
  for (std::size_t k = 0; k < a.size(); ++k)
    pairs.insert ({a[k], b[k]});
  const std::set<int> first (a.begin(), a.end());
  const std::set<int> second (b.begin(), b.end());
  return pairs.size() == first.size() && pairs.size() == second.size();
}

} // namespace test
} // namespace pcl_msf
