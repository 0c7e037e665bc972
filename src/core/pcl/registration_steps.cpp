// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <Eigen/LU>

#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/impl/registration_steps.h>

#include <cmath>

namespace pcl_msf {
namespace detail {

namespace {

constexpr float kRigidTolerance = 1e-2f;

} // namespace

Oversegmentation
segmentsHolding (const pcl::Indices& points,
                 const Oversegmentation& segments,
                 const RgbdFrame& frame)
{
  cv::Mat labels = segments.labels().clone();
  std::vector<char> wanted (segments.size(), 0);
  for (const auto index : points) {
    const int label = labels.at<int> (index / labels.cols, index % labels.cols);
    if (label >= 0)
      wanted[label] = 1;
  }
  for (int v = 0; v < labels.rows; ++v)
    for (int u = 0; u < labels.cols; ++u) {
      int& label = labels.at<int> (v, u);
      if (label >= 0 && !wanted[label])
        label = -1;
    }
  return Oversegmentation::fromLabels (labels, frame);
}

RigidPose
startPose (const UnalignedMatrix4& unaligned)
{
  const Eigen::Matrix4f guess = unaligned;
  const Eigen::Matrix3f r = guess.topLeftCorner<3, 3>();
  const Eigen::RowVector4f last_row (0.0f, 0.0f, 0.0f, 1.0f);
  const bool rigid =
      guess.allFinite() &&
      (r * r.transpose() - Eigen::Matrix3f::Identity()).norm() < kRigidTolerance &&
      r.determinant() > 0.0f && (guess.row (3) - last_row).norm() < kRigidTolerance;
  if (!rigid)
    throw InvalidInput ("the guess is not a rigid transformation: give a finite "
                        "rotation and translation, or none");
  return RigidPose::fromMatrix (guess);
}

std::string
whyUnusable (const SceneFlow& flow)
{
  if (flow.dominant_motion.isFinite())
    return {};
  return flow.report.message.empty() ? "the motion found is not finite"
                                     : flow.report.message;
}

int
pixelOf (const Eigen::Vector3f& point, const PinholeCamera& camera, cv::Size size)
{
  if (!(point.z() > 0.0f))
    return -1;
  const Eigen::Vector2d uv = camera.project (point.cast<double>());
  const bool inside = uv.x() >= -0.5 && uv.y() >= -0.5 && uv.x() < size.width - 0.5 &&
                      uv.y() < size.height - 0.5;
  if (!inside) // NaN, too
    return -1;
  const int u = static_cast<int> (std::floor (uv.x() + 0.5));
  const int v = static_cast<int> (std::floor (uv.y() + 0.5));
  return v * size.width + u;
}

MultiframeSceneFlow
failedFlow (StopReason reason, const std::string& message)
{
  MultiframeSceneFlow result;
  result.frames.resize (1);
  result.frames[0].report.stop_reason = reason;
  result.frames[0].report.message = message;
  return result;
}

const SceneFlow&
noSceneFlow ()
{
  static const SceneFlow none{};
  return none;
}

int
lastTarget (int frames, int reference)
{
  return reference == frames - 1 ? frames - 2 : frames - 1;
}

std::string
findPose (
    const MultiframeSceneFlow& result, int from, int to, int segment, RigidPose& pose)
{
  try {
    pose = result.poseBetween (from, to, segment);
    return {};
  }
  catch (const InvalidInput& error) {
    return error.what();
  }
}

std::function<bool (const Progress&)>
GuardedProgress::function()
{
  if (!callback_)
    return {};
  return [this] (const Progress& progress) {
    try {
      return callback_ (progress);
    }
    catch (...) {
      error_ = std::current_exception();
      return false;
    }
  };
}

} // namespace detail
} // namespace pcl_msf
