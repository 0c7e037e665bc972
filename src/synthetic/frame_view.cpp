// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/parallel_for.h"
#include <synthetic/frame_view.h>

#include <algorithm>
#include <cmath>

namespace pcl_msf::synthetic {
namespace {

constexpr double tile = 16.0; ///< pixels

/** How far a lens sees beyond an image of its size, along the image's border. */
double
borderOf (const Lens& lens, const PinholeCamera& camera, const cv::Size& size)
{
  if (lens.isNone())
    return 0.0;
  double border = 0.0;
  const auto look = [&] (double u, double v) {
    const Eigen::Vector2d p = lens.idealPixel (camera, u, v);
    border =
        std::max ({border, -p.x(), -p.y(), p.x() - size.width, p.y() - size.height});
  };
  for (double u = -0.5; u < size.width; u += 1.0)
    for (const double v : {-0.5, size.height - 0.5})
      look (u, v);
  for (double v = -0.5; v < size.height; v += 1.0)
    for (const double u : {-0.5, size.width - 0.5})
      look (u, v);
  return tile * std::ceil (border / tile);
}

} // namespace

FrameView::FrameView (const SceneModel& scene,
                      const PinholeCamera& camera,
                      const cv::Size& size,
                      double phase,
                      const Lens& lens)
: camera_ (camera)
, size_ (size)
, lens_ (lens)
, straight_ (lens.isNone())
, border_ (borderOf (lens, camera, size))
, world_from_camera_ (scene.world_from_camera (phase))
{
  // Image positions go from -0.5 to size - 0.5; half a tile more on all sides.
  columns_ = static_cast<int> ((size.width + 2.0 * border_) / tile) + 2;
  rows_ = static_cast<int> ((size.height + 2.0 * border_) / tile) + 2;
  tiles_.resize (static_cast<std::size_t> (columns_) * rows_);
  const Isometry camera_from_world = world_from_camera_.inverse();
  const auto index = [this] (double x, int count) {
    const double i = std::floor ((x + border_) / tile + 0.5);
    return static_cast<int> (std::clamp (i, -1.0, static_cast<double> (count)));
  };
  for (const Part& part : scene.parts) {
    parts_.push_back (makePartView (part,
                                    scene.bodies[part.body].world_from_body,
                                    camera_from_world,
                                    camera,
                                    phase));
    const cv::Rect2d box = parts_.back()->bounds();
    if (box.empty())
      continue;
    const int right = std::min (index (box.x + box.width, columns_), columns_ - 1);
    const int bottom = std::min (index (box.y + box.height, rows_), rows_ - 1);
    for (int r = std::max (index (box.y, rows_), 0); r <= bottom; ++r)
      for (int c = std::max (index (box.x, columns_), 0); c <= right; ++c)
        tiles_[r * columns_ + c].push_back (static_cast<int> (parts_.size()) - 1);
  }
}

ViewHit
FrameView::cast (double u, double v, double limit) const
{
  ViewHit nearest;
  const Eigen::Vector2d ideal = idealPixel (u, v);
  const double column = std::floor ((ideal.x() + border_) / tile + 0.5);
  const double row = std::floor ((ideal.y() + border_) / tile + 0.5);
  if (!(column >= 0.0 && row >= 0.0 && column < columns_ && row < rows_))
    return nearest;
  const int c = static_cast<int> (column), r = static_cast<int> (row);
  const Eigen::Vector3d ray = camera_.backProject (ideal.x(), ideal.y(), 1.0);
  for (const int p : tiles_[r * columns_ + c])
    if (parts_[p]->cast (ray, limit, nearest)) {
      nearest.part = p;
      limit = nearest.depth;
    }
  return nearest;
}

ImageViews::ImageViews (std::vector<std::unique_ptr<const FrameView>> views)
: size_ (views.front()->size())
, first_ (views.front().get())
, views_ (std::move (views))
{}

std::vector<ViewHit>
castPixels (const ImageViews& views, int threads)
{
  const cv::Size size = views.size();
  std::vector<ViewHit> hits (static_cast<std::size_t> (size.area()));
  parallelFor (threads, size.height, 4, [&] (int v) {
    for (int u = 0; u < size.width; ++u)
      hits[static_cast<std::size_t> (v) * size.width + u] = views.row (v).cast (u, v);
  });
  return hits;
}

} // namespace pcl_msf::synthetic
