// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/console/print.h>

#include <Eigen/LU>

#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/impl/registration_steps.h>

#include <cmath>

namespace pcl_msf {
namespace detail {

namespace {

constexpr double kSuspiciousError = 2.0; // pixels, of a camera that the user gave
constexpr float kRigidTolerance = 1e-2f;

std::string
sizeText (const cv::Mat& image)
{
  return std::to_string (image.cols) + "x" + std::to_string (image.rows);
}

void
requireDepth (const cv::Mat& depth, const FrameParameters& range, const char* name)
{
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u) {
      const float z = depth.at<float> (v, u);
      if (z > 0.0f && z >= range.min_depth && z <= range.max_depth)
        return;
    }
  throw InvalidInput (std::string ("no point of the ") + name +
                      " has a valid depth: z must be positive, in metres, between " +
                      "FrameParameters' min_depth and max_depth");
}

PinholeCamera
checkedCamera (const PinholeCamera& camera, const CloudImages& source)
{
  std::string why;
  if (!camera.isValid (source.points.cols, source.points.rows, &why))
    throw InvalidInput (why + ", by setCamera");
  if (projectionError (source.points, camera) > kSuspiciousError)
    PCL_WARN ("[pcl_msf::PiecewiseRigidRegistration::align] the source's points miss "
              "their pixels by %g px: is setCamera's camera the source's own?\n",
              projectionError (source.points, camera));
  return camera;
}

PinholeCamera
estimatedCamera (const CloudImages& source, const CloudImages& target)
{
  PinholeCamera camera;
  std::string why;
  if (!estimateCamera (source.points, camera, &why))
    throw InvalidInput ("no camera is set and the source does not tell it: " + why +
                        "; call setCamera");
  if (projectionError (target.points, camera) > kSuspiciousError)
    throw InvalidInput ("the target was not taken by the camera estimated from the "
                        "source; give clouds of one camera, or call setCamera");
  return camera;
}

} // namespace

FramePair
makeFrames (CloudImages source,
            CloudImages target,
            const PinholeCamera& camera,
            const FrameParameters& parameters,
            const cv::Mat& source_normals)
{
  if (source.points.size() != target.points.size())
    throw InvalidInput ("the source has " + sizeText (source.points) +
                        " points, the target " + sizeText (target.points) +
                        ": give clouds of one size");
  if (!source_normals.empty() && source_normals.size() != source.points.size())
    throw InvalidInput ("the source has " + sizeText (source.points) +
                        " points, its normals " + sizeText (source_normals) +
                        ": call setSourceNormals with the source's own, or with null");
  const cv::Mat source_depth = depthImage (source.points);
  const cv::Mat target_depth = depthImage (target.points);
  requireDepth (source_depth, parameters, "source");
  requireDepth (target_depth, parameters, "target");
  const PinholeCamera used = camera.fx != 0.0 ? checkedCamera (camera, source)
                                              : estimatedCamera (source, target);
  normalizeIntensity (source.color, target.color);
  cv::Mat normals = source_normals.clone();
  if (!normals.empty())
    cv::patchNaNs (normals, 0.0);
  FrameParameters target_parameters = parameters;
  target_parameters.normals = NormalMethod::None;
  return {RgbdFrame::fromImages (source.color, source_depth, used, parameters, normals),
          RgbdFrame::fromImages (target.color, target_depth, used, target_parameters)};
}

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
startPose (const Eigen::Matrix4f& guess)
{
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
  if (flow.dominant_body >= 0 && flow.dominant_motion.isFinite())
    return {};
  if (!flow.report.message.empty())
    return flow.report.message;
  return "no segment's motion could be determined: the clouds may show nothing in "
         "common; give clouds that overlap, or a guess";
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

SceneFlow
failedFlow (StopReason reason, const std::string& message)
{
  SceneFlow flow;
  flow.report.stop_reason = reason;
  flow.report.message = message;
  return flow;
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
