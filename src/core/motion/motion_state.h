// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <pcl_msf/rigid_pose.h>

#include <utility>
#include <vector>

namespace pcl_msf {

/** \brief A pair of neighbouring segments: an element of Psi (section 3). */
struct SegmentLink {
  int first{0}; ///< first < second
  int second{0};
  Eigen::Vector3d midpoint; ///< between the centroids, reference frame, metres
  double lever{0.0};        ///< half the distance of the centroids, metres
  double strength{1.0};     ///< factor on what the link costs, 1 in the mean
};

/** \brief A pose unpacked, where its rotation is needed again and again. */
struct UnpackedPose {
  Eigen::Matrix3d rotation;
  Eigen::Vector3d translation;
  Eigen::Vector3d rotation_vector;

  UnpackedPose() = default;
  UnpackedPose (const RigidPose& pose)
  : rotation (pose.rotation())
  , translation (pose.translation())
  , rotation_vector (pose.parameters[0], pose.parameters[1], pose.parameters[2])
  {}
};

/** \brief One pair's share of the unknowns: a pose per body. */
struct MotionState {
  std::vector<int> body_of;     ///< per segment
  std::vector<RigidPose> poses; ///< per body, current_from_reference
  std::vector<double> weights;  ///< per link, w_{j,h}

  const RigidPose&
  poseOf (int segment) const
  {
    return poses[body_of[segment]];
  }

  /** \brief One body per segment with the given poses. */
  static MotionState
  fromSegments (std::vector<RigidPose> poses, std::size_t links)
  {
    MotionState state;
    state.body_of.resize (poses.size());
    for (std::size_t k = 0; k < poses.size(); ++k)
      state.body_of[k] = static_cast<int> (k);
    state.poses = std::move (poses);
    state.weights.assign (links, 1.0);
    return state;
  }
};

/** \brief The unknowns of Eq. 13: poses per pair and body, weights shared by all pairs.
 *
 * All pairs have the same bodies; each segment is a body of its own until bodies are
 * merged. Two frames (Eq. 5) are a window of one pair. */
struct WindowState {
  std::vector<int> body_of;                  ///< per segment
  std::vector<std::vector<RigidPose>> poses; ///< per pair, per body
  std::vector<double> weights;               ///< per link

  WindowState() = default;

  /** \brief The window of one pair. */
  explicit WindowState (MotionState state)
  : body_of (std::move (state.body_of))
  , poses{std::move (state.poses)}
  , weights (std::move (state.weights))
  {}

  int
  bodies () const
  {
    return poses.empty() ? 0 : static_cast<int> (poses[0].size());
  }

  MotionState
  ofPair (int pair) const
  {
    return {body_of, poses[pair], weights};
  }

  /** \brief Bodies without segments disappear; the others are numbered in the order of
   * the segments. \return what they were before */
  std::vector<int>
  renumberBodies ();

  /** \brief Linked segments of equal poses, in all pairs, become one body; numbered
   * likewise. \param alone per segment: does it stay one by itself? Empty: none */
  void
  joinEqualPoses (const std::vector<SegmentLink>& links,
                  const std::vector<char>& alone = {});

  /** \brief Each segment becomes a body of its own, where it is. */
  void
  separate ();

  /** \brief The body of most segments, the first among equals; 0 without segments. */
  int
  largestBody () const;
};

} // namespace pcl_msf
