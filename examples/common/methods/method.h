// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/io/rgbd_sequence.h>
#include <pcl_msf/scene_flow.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief Two frames and what is known of the motion between them. */
struct PairData {
  io::RgbdImages reference;
  io::RgbdImages current;
  io::MotionTruth truth;
  std::optional<RigidPose> camera_motion; ///< of static points, current_from_reference
};

/** \brief Seconds of a run; NaN where a method has no such stage. Of optical flow,
 * `solve` is the flow alone, the rest of `total` is lifting it. */
struct StageSeconds {
  double total, frame, segment, start, solve, result;

  StageSeconds();
};

/** \brief What a method says about a pair. */
struct Estimate {
  cv::Mat flow;         ///< CV_32FC2, pixels; NaN = unknown
  cv::Mat displacement; ///< CV_32FC3, metres; NaN = unknown
  bool lifted{false};   ///< z is the current depth: no depth residual by construction
  cv::Mat visible;      ///< CV_8UC1, 255 = reported visible; empty = no report
  std::optional<RigidPose> dominant;   ///< current_from_reference
  std::optional<SceneFlow> scene_flow; ///< of our own method
  StageSeconds seconds;
};

/** \brief One way to estimate motion: ours, a variant of it, or a baseline. */
class Method {
public:
  virtual ~Method() = default;

  /** \brief Does it need colour? Then it is left out on depth-only pairs. */
  virtual bool
  needsColor () const = 0;

  /** \brief Does it need true motion of this pair? Then likewise without. */
  virtual bool
  canRun (const PairData& pair) const;

  virtual Estimate
  run (const PairData& pair) const = 0;
};

/** \brief A method by its name. `threads` 0 = all.
 * \throws UsageError naming what exists for an unknown name or a bad setting */
std::unique_ptr<Method>
makeMethod (const std::string& spec, unsigned threads);

/** \brief Names of all methods with one line each, for --help. */
std::vector<std::pair<std::string, std::string>>
methodHelp ();

} // namespace pcl_msf::tool
