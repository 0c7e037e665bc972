// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/export.h>
#include <pcl_msf/rigid_pose.h>
#include <pcl_msf/synthetic/sequence_options.h>

#include <string>
#include <vector>

namespace pcl_msf::synthetic {

/** \brief One RGB-D image as the sensor delivers it. */
struct SyntheticFrame {
  cv::Mat color; ///< CV_8UC3, BGR
  cv::Mat depth; ///< CV_32FC1, metres along z at pixel centres; NaN = no measurement
};

/** \brief Where the points of one frame are in a later one; of the scene itself, so
 * without the sensor's noise and holes. NaN where nothing is hit (sky). */
struct GroundTruth {
  cv::Mat flow; ///< CV_32FC2, pixels (u, v); NaN also for points behind the camera
  cv::Mat scene_flow; ///< CV_32FC3, metres (x, y, z), later minus earlier camera frame
  cv::Mat visible;    ///< CV_8UC1, 255 = seen in both frames, 0 = hidden, out of view
};

/** \brief What has one label. */
struct SyntheticBody {
  std::string name;
  bool rigid{true}; ///< no: the poses are those of its frame; points move otherwise

  /** \brief Element k: frame-0 point to frame-k point, camera coordinates. */
  std::vector<RigidPose> framek_from_frame0;
};

/** \brief An RGB-D sequence with exact truth. Copies share the images. */
struct SyntheticSequence {
  SequenceOptions options; ///< what it was made from
  PinholeCamera camera;    ///< of all frames
  std::vector<SyntheticFrame> frames;
  std::vector<GroundTruth> truth; ///< element k: frame 0 to frame k; 0 = no motion

  /** \brief Element k: frame k to k + 1; empty unless asked for. */
  std::vector<GroundTruth> successive_truth;

  cv::Mat labels; ///< CV_32SC1, body of each pixel of frame 0, -1 = nothing hit
  std::vector<SyntheticBody> bodies; ///< element l: what has label l; 0 = static scene

  /** \brief Element k: camera pose, frame-k camera to frame-0 camera coordinates. */
  std::vector<RigidPose> frame0_from_framek;
};

/** \brief Renders a sequence by analytic ray casting.
 *
 * Depth and truth are exact to 1e-6 m before rounding to float; colour is the average
 * of supersampling^2 rays a pixel. Surface colours and shading are fixed to the
 * surface. Thread-safe. \throws InvalidInput for options that are not valid */
PCL_MSF_EXPORT SyntheticSequence
synthesize (const SequenceOptions& options);

} // namespace pcl_msf::synthetic
