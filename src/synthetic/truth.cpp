// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/parallel_for.h"
#include <synthetic/truth.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_msf::synthetic {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/** Is nothing in front of a point of the view's scene that projects to a pixel? */
bool
isSeen (const FrameView& view, const Eigen::Vector3d& point, const Eigen::Vector2d& uv)
{
  const cv::Size size = view.size();
  if (!(uv.x() >= -0.5 && uv.y() >= -0.5 && uv.x() < size.width - 0.5 &&
        uv.y() < size.height - 0.5))
    return false;
  const double tolerance = 1e-5 * (1.0 + point.z());
  return view.cast (uv.x(), uv.y(), point.z() - tolerance).part < 0;
}

template <typename F>
void
forEachHit (const cv::Size& size, const std::vector<ViewHit>& hits, F&& f)
{
  for (int v = 0; v < size.height; ++v)
    for (int u = 0; u < size.width; ++u) {
      const ViewHit& hit = hits[static_cast<std::size_t> (v) * size.width + u];
      if (hit.part >= 0)
        f (u, v, hit);
    }
}

} // namespace

cv::Mat
depthOf (const cv::Size& size, const std::vector<ViewHit>& hits)
{
  cv::Mat depth (size, CV_32FC1, cv::Scalar::all (nan));
  forEachHit (size, hits, [&] (int u, int v, const ViewHit& hit) {
    depth.at<float> (v, u) = static_cast<float> (hit.depth);
  });
  return depth;
}

cv::Mat
labelsOf (const SceneModel& scene,
          const FrameView& view,
          const std::vector<ViewHit>& hits)
{
  cv::Mat labels (view.size(), CV_32SC1, cv::Scalar::all (-1));
  forEachHit (view.size(), hits, [&] (int u, int v, const ViewHit& hit) {
    labels.at<int> (v, u) = scene.parts[hit.part].body;
  });
  return labels;
}

GroundTruth
truthBetween (const FrameView& from,
              const std::vector<ViewHit>& hits,
              const FrameView& to,
              int threads)
{
  const cv::Size size = from.size();
  GroundTruth truth;
  truth.flow = cv::Mat (size, CV_32FC2, cv::Scalar::all (nan));
  truth.scene_flow = cv::Mat (size, CV_32FC3, cv::Scalar::all (nan));
  truth.visible = cv::Mat::zeros (size, CV_8UC1);
  parallelFor (threads, size.height, 4, [&] (int v) {
    for (int u = 0; u < size.width; ++u) {
      const ViewHit& hit = hits[static_cast<std::size_t> (v) * size.width + u];
      if (hit.part < 0)
        continue;
      const Eigen::Vector3d later = to.part (hit.part).place (hit.material);
      const Eigen::Vector3f step =
          (later - hit.point (from.direction (u, v))).cast<float>();
      truth.scene_flow.at<cv::Vec3f> (v, u) = {step.x(), step.y(), step.z()};
      if (!(later.z() > 1e-6))
        continue;
      const Eigen::Vector2d uv = to.camera().project (later);
      truth.flow.at<cv::Vec2f> (v, u) = {static_cast<float> (uv.x() - u),
                                         static_cast<float> (uv.y() - v)};
      if (isSeen (to, later, uv))
        truth.visible.at<unsigned char> (v, u) = 255;
    }
  });
  return truth;
}

double
meanMotion (const SceneModel& scene,
            const FrameView& from,
            const std::vector<ViewHit>& hits,
            const FrameView& to)
{
  double sum[2] = {0.0, 0.0};
  int count[2] = {0, 0};
  const double most = from.size().width;
  forEachHit (from.size(), hits, [&] (int u, int v, const ViewHit& hit) {
    const Eigen::Vector3d later = to.part (hit.part).place (hit.material);
    double length = most;
    if (later.z() > 1e-6)
      length = (to.camera().project (later) - Eigen::Vector2d (u, v)).norm();
    const int moving = scene.parts[hit.part].body > 0;
    sum[moving] += std::min (length, most);
    ++count[moving];
  });
  const double all = (sum[0] + sum[1]) / std::max (1, count[0] + count[1]);
  return std::max (all, sum[1] / std::max (1, count[1]));
}

} // namespace pcl_msf::synthetic
