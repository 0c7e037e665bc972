// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/export.h>
#include <pcl_msf/io/rgbd_images.h>
#include <pcl_msf/rigid_pose.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl_msf::io {

/** \brief What is known about the motion from one frame to another. Images have the
 * first frame's size and belong to its pixels; what is not known is empty. */
struct MotionTruth {
  cv::Mat flow;       ///< CV_32FC2, pixels (u, v); NaN = unknown
  cv::Mat scene_flow; ///< CV_32FC3, metres (x, y, z); NaN = unknown
  cv::Mat visible;    ///< CV_8UC1, 255 = seen in both frames
  cv::Mat labels;     ///< CV_32SC1, bodies or objects of the first frame, -1 = none
  std::vector<std::optional<RigidPose>>
      bodies; ///< per label, `to_from_from`: rigid motion, none for soft bodies
  std::optional<RigidPose> rigid; ///< `to_from_from`, when the whole scene is one body
};

/** \brief Frames of a recording, from any data set, with what is known about them.
 *
 * Nothing is read before it is asked for; const and thread-safe. Every reader throws
 * IoError ("file: field: problem") for a file that is missing or damaged.
 */
class PCL_MSF_EXPORT RgbdSequence {
public:
  virtual ~RgbdSequence() = default;

  /** \brief For tables and folders, e.g. "alley_1". */
  virtual std::string
  name () const = 0;

  virtual int
  frames () const = 0;

  /** \param k 0 .. frames () - 1 */
  virtual RgbdImages
  frame (int k) const = 0;

  /** \brief Of frame k, seconds; NaN when the recording has none. */
  virtual double
  timestamp (int k) const;

  /** \brief What is known of the motion between two frames, from < to or from > to. */
  virtual MotionTruth
  truth (int from, int to) const;

  /** \brief `world_from_camera` of frame k. */
  virtual std::optional<RigidPose>
  cameraPose (int k) const;

  /** \brief Do the data define their unit of depth, so that `depth` is in metres (or in
   * the unit of its models) whatever its values are? Else, the default, it is as files
   * or DatasetOptions::depth_scale say, which may be wrong. */
  virtual bool
  definesDepthUnit () const;
};

} // namespace pcl_msf::io
