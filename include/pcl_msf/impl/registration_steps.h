// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/types.h>

#include <Eigen/Core>

#include <opencv2/core.hpp>

#include <pcl_msf/export.h>
#include <pcl_msf/multiframe_scene_flow.h>
#include <pcl_msf/oversegmentation.h>
#include <pcl_msf/rgbd_frame.h>
#include <pcl_msf/scene_flow.h>

#include <chrono>
#include <cstddef>
#include <exception>
#include <functional>
#include <string>
#include <vector>

/* The steps of PiecewiseRigidRegistration that don't depend on the point type: compiled
 * once, not part of the public interface. */
namespace pcl_msf {
namespace detail {

struct CloudImages {
  cv::Mat points; ///< as from coordinateImage
  cv::Mat color;  ///< as from colorImage
};

/** An empty result. */
PCL_MSF_EXPORT const SceneFlow&
noSceneFlow ();

/** A target's name in messages: by its number, from 1, when there are several. */
PCL_MSF_EXPORT std::string
targetName (std::size_t target, std::size_t targets);

/** Frames of clouds, in the order of time (section 3.3). A camera with fx = 0 is
 * estimated from the source, which is clouds[reference]; all clouds must fit the
 * camera. \param intensity_unit of a stream: the least one to use in, the one used out;
 * null for clouds that are all of it \throws InvalidInput naming the remedy in terms of
 * PiecewiseRigidRegistration */
PCL_MSF_EXPORT std::vector<RgbdFrame>
makeFrames (std::vector<CloudImages> clouds,
            int reference,
            const PinholeCamera& camera,
            const FrameParameters& parameters,
            const cv::Mat& source_normals,
            double* intensity_unit = nullptr);

/** The segments that hold at least one of the points, each with all of its points. */
PCL_MSF_EXPORT Oversegmentation
segmentsHolding (const pcl::Indices& points,
                 const Oversegmentation& segments,
                 const RgbdFrame& frame);

/** A 4x4 matrix that code compiled with any vector instructions may hand over. */
using UnalignedMatrix4 = Eigen::Matrix<float, 4, 4, Eigen::DontAlign>;

/** The guess as a pose. \throws InvalidInput when it is not a rigid transformation */
PCL_MSF_EXPORT RigidPose
startPose (const UnalignedMatrix4& guess);

/** Why a result cannot be used; empty when it can. */
PCL_MSF_EXPORT std::string
whyUnusable (const SceneFlow& flow);

/** The pixel that a point projects to, row * width + column; -1 outside the image. */
PCL_MSF_EXPORT int
pixelOf (const Eigen::Vector3f& point, const PinholeCamera& camera, cv::Size size);

/** A result that says only why there is none. */
PCL_MSF_EXPORT MultiframeSceneFlow
failedFlow (StopReason reason, const std::string& message);

/** Index of the last frame of a window that is a target. */
PCL_MSF_EXPORT int
lastTarget (int frames, int reference);

/** The pose between two frames, as in poseBetween, into `pose`.
 * \return why there is none; empty when there is one */
PCL_MSF_EXPORT std::string
findPose (
    const MultiframeSceneFlow& result, int from, int to, int segment, RigidPose& pose);

/** Passes progress on; an exception of the callback cancels and is kept for rethrow,
 * because it must not fly through the solver. */
class PCL_MSF_EXPORT GuardedProgress {
public:
  explicit GuardedProgress (std::function<bool (const Progress&)> callback)
  : callback_ (std::move (callback))
  {}
  /** The callback to give to the solver; empty when there is none. */
  std::function<bool (const Progress&)>
  function ();
  void
  rethrow () const
  {
    if (error_)
      std::rethrow_exception (error_);
  }

private:
  std::function<bool (const Progress&)> callback_;
  std::exception_ptr error_;
};

/** Seconds between two calls of lap. */
class Stopwatch {
public:
  double
  lap ()
  {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> seconds = now - start_;
    start_ = now;
    return seconds.count();
  }

private:
  std::chrono::steady_clock::time_point start_{std::chrono::steady_clock::now()};
};

} // namespace detail
} // namespace pcl_msf
