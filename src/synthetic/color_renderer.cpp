// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/parallel_for.h"
#include <synthetic/color_renderer.h>

#include <algorithm>
#include <cmath>

namespace pcl_msf::synthetic {
namespace {

/** Size of a pixel on the surface: the mean of its two extents. */
float
footprintOf (const FrameView& view,
             const ViewHit& hit,
             const Eigen::Vector3d& direction)
{
  const double facing = std::max (0.05, -hit.normal.dot (direction) / direction.norm());
  const double across = hit.depth / view.camera().fx;
  return static_cast<float> (0.5 * across * (1.0 + 1.0 / facing));
}

/** Do all eight neighbours lie on the hit's tangent plane, on the same part? */
bool
isSmooth (const FrameView& view, const std::vector<ViewHit>& hits, int u, int v)
{
  const cv::Size size = view.size();
  if (u < 1 || v < 1 || u + 1 >= size.width || v + 1 >= size.height)
    return false;
  const std::size_t index = static_cast<std::size_t> (v) * size.width + u;
  const ViewHit& hit = hits[index];
  const Eigen::Vector3d ray = view.direction (u, v);
  if (hit.part < 0 || -hit.normal.dot (ray) < 0.15 * ray.norm())
    return false;
  const double pixel = hit.depth / view.camera().fx;
  for (int dv = -1; dv <= 1; ++dv)
    for (int du = -1; du <= 1; ++du) {
      const ViewHit& other = hits[index + dv * size.width + du];
      if (other.part != hit.part || other.normal.dot (hit.normal) < 0.95)
        return false;
      const Eigen::Vector3d step =
          other.point (view.direction (u + du, v + dv)) - hit.point (ray);
      if (std::abs (step.dot (hit.normal)) > 0.2 * pixel)
        return false;
    }
  return true;
}

} // namespace

ColorRenderer::ColorRenderer (const SceneModel& scene, unsigned seed, int supersampling)
: scene_ (scene), noise_ (seed), supersampling_ (supersampling)
{
  for (const Part& part : scene.parts) {
    const Isometry world_from_part =
        scene.bodies[part.body].world_from_body (0.0) * part.body_from_part;
    lights_.push_back (world_from_part.linear().transpose() * scene.light.normalized());
  }
}

cv::Mat
ColorRenderer::render (const ImageViews& views,
                       const std::vector<ViewHit>& hits,
                       int threads) const
{
  const cv::Size size = views.size();
  cv::Mat image (size, CV_32FC3);
  parallelFor (threads, size.height, 4, [&] (int v) {
    auto* row = image.ptr<cv::Vec3f> (v);
    for (int u = 0; u < size.width; ++u) {
      const Eigen::Vector3f color = pixelColor (views.row (v), hits, u, v);
      row[u] = {color.x(), color.y(), color.z()};
    }
  });
  return image;
}

Eigen::Vector3f
ColorRenderer::pixelColor (const FrameView& view,
                           const std::vector<ViewHit>& hits,
                           int u,
                           int v) const
{
  if (!isSmooth (view, hits, u, v))
    return edgePixel (view, u, v);
  const std::size_t index = static_cast<std::size_t> (v) * view.size().width + u;
  return smoothPixel (view, hits[index], u, v);
}

/** On smooth surfaces the rays within a pixel meet its tangent plane. */
Eigen::Vector3f
ColorRenderer::smoothPixel (const FrameView& view,
                            const ViewHit& hit,
                            int u,
                            int v) const
{
  const Part& part = scene_.parts[hit.part];
  const PartView& part_view = view.part (hit.part);
  const Eigen::Vector3d ray = view.direction (u, v);
  const Eigen::Vector3d point = hit.point (ray);
  const Eigen::Matrix3d material_from_camera = part_view.materialFromCamera (hit);
  const double height = hit.normal.dot (point);
  const float footprint = footprintOf (view, hit, ray);
  Eigen::Vector3f normal;
  const float light = shade (part, hit.part, hit, part_view, normal);
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (int j = 0; j < supersampling_; ++j)
    for (int i = 0; i < supersampling_; ++i) {
      const Eigen::Vector3d d = view.direction (u + offset (i), v + offset (j));
      const Eigen::Vector3d step = height / hit.normal.dot (d) * d - point;
      const Eigen::Vector3d place = hit.material + material_from_camera * step;
      sum +=
          textureColor (part.texture, noise_, place.cast<float>(), normal, footprint);
    }
  return light / static_cast<float> (supersampling_ * supersampling_) * sum;
}

Eigen::Vector3f
ColorRenderer::edgePixel (const FrameView& view, int u, int v) const
{
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (int j = 0; j < supersampling_; ++j)
    for (int i = 0; i < supersampling_; ++i) {
      const double x = u + offset (i), y = v + offset (j);
      sum += hitColor (view, view.cast (x, y), view.direction (x, y));
    }
  return sum / static_cast<float> (supersampling_ * supersampling_);
}

Eigen::Vector3f
ColorRenderer::hitColor (const FrameView& view,
                         const ViewHit& hit,
                         const Eigen::Vector3d& direction) const
{
  if (hit.part < 0)
    return skyColor (view, direction);
  const Part& part = scene_.parts[hit.part];
  Eigen::Vector3f normal;
  const float light = shade (part, hit.part, hit, view.part (hit.part), normal);
  return light * textureColor (part.texture,
                               noise_,
                               hit.material.cast<float>(),
                               normal,
                               footprintOf (view, hit, direction));
}

/** Lambert's law at phase 0, so that it is fixed to the surface. */
float
ColorRenderer::shade (const Part& part,
                      int index,
                      const ViewHit& hit,
                      const PartView& view,
                      Eigen::Vector3f& normal) const
{
  const Eigen::Vector3d rest = view.restNormal (hit);
  // A soft surface's material coordinates are flat.
  normal = part.soft ? Eigen::Vector3f (0.0f, 0.0f, 1.0f) : rest.cast<float>();
  const double facing = rest.dot (lights_[index]);
  return static_cast<float> (0.7 + 0.3 * facing);
}

Eigen::Vector3f
ColorRenderer::skyColor (const FrameView& view, const Eigen::Vector3d& direction) const
{
  if (!scene_.sky)
    return Eigen::Vector3f::Zero();
  const Eigen::Vector3d d = (view.worldFromCamera().linear() * direction).normalized();
  const Eigen::Vector3f place = (4.0 * d).cast<float>();
  const float cloud = 0.6f * noise_ (place * 1.5f) + 0.4f * noise_ (place * 4.0f);
  return Eigen::Vector3f (215.0f, 190.0f, 165.0f) +
         cloud * Eigen::Vector3f (25.0f, 45.0f, 60.0f);
}

} // namespace pcl_msf::synthetic
