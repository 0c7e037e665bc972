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

std::string
targetName (std::size_t target, std::size_t targets)
{
  if (targets < 2)
    return "target";
  return "target " + std::to_string (target + 1) + " of " + std::to_string (targets);
}

namespace {

constexpr double kSuspiciousError = 2.0; // pixels, of a camera that the user gave
constexpr float kRigidTolerance = 1e-2f;

std::string
sizeText (const cv::Mat& image)
{
  return std::to_string (image.cols) + "x" + std::to_string (image.rows);
}

/** A cloud's name in messages. \param frame in the window with the source */
std::string
frameName (std::size_t frame, int reference, std::size_t frames)
{
  const auto source = static_cast<std::size_t> (reference);
  if (frame == source)
    return "source";
  return targetName (frame > source ? frame - 1 : frame, frames - 1);
}

void
requireDepth (const cv::Mat& depth,
              const FrameParameters& range,
              const std::string& name)
{
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u) {
      const float z = depth.at<float> (v, u);
      if (z > 0.0f && z >= range.min_depth && z <= range.max_depth)
        return;
    }
  throw InvalidInput ("no point of the " + name +
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
estimatedCamera (const std::vector<CloudImages>& clouds, int reference)
{
  PinholeCamera camera;
  std::string why;
  if (!estimateCamera (clouds[reference].points, camera, &why))
    throw InvalidInput ("no camera is set and the source does not tell it: " + why +
                        "; call setCamera");
  for (std::size_t k = 0; k < clouds.size(); ++k)
    if (projectionError (clouds[k].points, camera) > kSuspiciousError)
      throw InvalidInput ("the " + frameName (k, reference, clouds.size()) +
                          " was not taken by the camera estimated from the "
                          "source; give clouds of one camera, or call setCamera");
  return camera;
}

void
requireOneSize (const std::vector<CloudImages>& clouds,
                int reference,
                const cv::Mat& normals)
{
  const cv::Mat& source = clouds[reference].points;
  for (std::size_t k = 0; k < clouds.size(); ++k)
    if (clouds[k].points.size() != source.size())
      throw InvalidInput ("the source has " + sizeText (source) + " points, the " +
                          frameName (k, reference, clouds.size()) + " " +
                          sizeText (clouds[k].points) + ": give clouds of one size");
  if (!normals.empty() && normals.size() != source.size())
    throw InvalidInput ("the source has " + sizeText (source) +
                        " points, its normals " + sizeText (normals) +
                        ": call setSourceNormals with the source's own, or with null");
}

} // namespace

std::vector<RgbdFrame>
makeFrames (std::vector<CloudImages> clouds,
            int reference,
            const PinholeCamera& camera,
            const FrameParameters& parameters,
            const cv::Mat& source_normals)
{
  requireOneSize (clouds, reference, source_normals);
  const int count = static_cast<int> (clouds.size());
  std::vector<cv::Mat> depths;
  for (const CloudImages& cloud : clouds)
    depths.push_back (depthImage (cloud.points));
  requireDepth (depths[reference], parameters, "source");
  for (int k = 0; k < count; ++k)
    if (k != reference)
      requireDepth (depths[k], parameters, frameName (k, reference, clouds.size()));
  const PinholeCamera used = camera.fx != 0.0
                                 ? checkedCamera (camera, clouds[reference])
                                 : estimatedCamera (clouds, reference);
  std::vector<cv::Mat*> colors;
  for (CloudImages& cloud : clouds)
    colors.push_back (&cloud.color);
  normalizeIntensity (colors);
  cv::Mat normals = source_normals.clone();
  if (!normals.empty())
    cv::patchNaNs (normals, 0.0);
  std::vector<RgbdFrame> frames;
  for (int k = 0; k < count; ++k) {
    // The outermost frames are targets only: nothing is aligned from there.
    const bool outermost = k != reference && (k == 0 || k == count - 1);
    FrameParameters own = parameters;
    if (outermost)
      own.normals = NormalMethod::Skip;
    frames.push_back (RgbdFrame::fromImages (
        clouds[k].color, depths[k], used, own, k == reference ? normals : cv::Mat()));
  }
  return frames;
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
  static const SceneFlow none;
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
