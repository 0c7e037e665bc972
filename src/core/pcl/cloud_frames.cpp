// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/console/print.h>

#include "core/frame/depth_range.h"
#include "core/frame/frame_size.h"
#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/impl/registration_steps.h>

#include <algorithm>

/* makeFrames: clouds are judged, then they become frames. */
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

/** A cloud's name in messages. \param frame in the window with the source */
std::string
frameName (std::size_t frame, int reference, std::size_t frames)
{
  if (frames == 1)
    return "cloud";
  const auto source = static_cast<std::size_t> (reference);
  if (frame == source)
    return "source";
  return targetName (frame > source ? frame - 1 : frame, frames - 1);
}

void
requireSizes (const std::vector<CloudImages>& clouds,
              int reference,
              const cv::Mat& normals)
{
  const cv::Size source = clouds[reference].points.size();
  const std::string why = whyTooSmall (source);
  if (!why.empty())
    throw InvalidInput ("the " + frameName (reference, reference, clouds.size()) + " " +
                        why + ": give the whole image, or a larger part");
  for (std::size_t k = 0; k < clouds.size(); ++k)
    if (clouds[k].points.size() != source)
      throw InvalidInput ("the source has " + sizeText (source) + " points, the " +
                          frameName (k, reference, clouds.size()) + " " +
                          sizeText (clouds[k].points.size()) +
                          ": give clouds of one size");
  if (!normals.empty() && normals.size() != source)
    throw InvalidInput ("the source has " + sizeText (source) +
                        " points, its normals " + sizeText (normals.size()) +
                        ": call setSourceNormals with the source's own, or with null");
}

/** The depth of a cloud; what its limits drop is told. */
cv::Mat
checkedDepth (const cv::Mat& points,
              const FrameParameters& parameters,
              const std::string& name)
{
  const cv::Mat depth = depthImage (points);
  std::string why;
  if (!hasDepth (depth, parameters, &why)) {
    PinholeCamera camera;
    std::string cause;
    const bool behind = cv::countNonZero (depth > 0.0) == 0 &&
                        cv::countNonZero (depth < 0.0) > 0 &&
                        !estimateCamera (points, camera, &cause);
    throw InvalidInput ("no point of the " + name +
                        " has a valid depth (z must be positive, in metres): " + why +
                        (behind ? "; " + cause : std::string()));
  }
  const std::string dropped = droppedDepth (depth, parameters);
  if (!dropped.empty())
    PCL_WARN ("[pcl_msf] %s: %s\n", name.c_str(), dropped.c_str());
  return depth;
}

PinholeCamera
estimatedCamera (const std::vector<CloudImages>& clouds, int reference)
{
  PinholeCamera camera;
  std::string why;
  if (!estimateCamera (clouds[reference].points, camera, &why))
    throw InvalidInput ("no camera is set (setCamera) and the " +
                        frameName (reference, reference, clouds.size()) +
                        " does not tell it: " + why);
  return camera;
}

void
requireCamera (const std::vector<CloudImages>& clouds,
               int reference,
               const PinholeCamera& camera,
               bool given)
{
  const cv::Size size = clouds[reference].points.size();
  std::string why;
  if (!camera.isValid (size.width, size.height, &why))
    throw InvalidInput (why + ", by setCamera");
  const std::string which = given ? " is no image of the camera in use, give "
                                    "clouds of one camera in its optical frame: "
                                  : " was not taken by the camera estimated from the "
                                    "source, give clouds of one camera: ";
  for (std::size_t k = 0; k < clouds.size(); ++k)
    if (!fitsCamera (clouds[k].points, camera, &why))
      throw InvalidInput ("the " + frameName (k, reference, clouds.size()) + which +
                          why);
}

void
normalizeTogether (std::vector<CloudImages>& clouds, double* least_unit)
{
  std::vector<cv::Mat*> colors;
  for (CloudImages& cloud : clouds)
    colors.push_back (&cloud.color);
  double unit = intensityUnit (colors);
  if (least_unit)
    unit = *least_unit = std::max (unit, *least_unit);
  normalizeIntensity (colors, unit);
}

} // namespace

std::vector<RgbdFrame>
makeFrames (std::vector<CloudImages> clouds,
            int reference,
            const PinholeCamera& camera,
            const FrameParameters& parameters,
            const cv::Mat& source_normals,
            double* intensity_unit)
{
  requireSizes (clouds, reference, source_normals);
  const int count = static_cast<int> (clouds.size());
  std::vector<cv::Mat> depths;
  for (int k = 0; k < count; ++k)
    depths.push_back (checkedDepth (
        clouds[k].points, parameters, frameName (k, reference, clouds.size())));
  const bool given = camera.fx != 0.0;
  const PinholeCamera used = given ? camera : estimatedCamera (clouds, reference);
  requireCamera (clouds, reference, used, given);
  normalizeTogether (clouds, intensity_unit);
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

} // namespace detail
} // namespace pcl_msf
