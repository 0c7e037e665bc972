// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/parallel_for.h"
#include <synthetic/frame_view.h>

#include <algorithm>
#include <cmath>

namespace pcl_msf::synthetic {
namespace {

constexpr double tile = 16.0; ///< pixels

} // namespace

FrameView::FrameView (const SceneModel& scene,
                      const PinholeCamera& camera,
                      const cv::Size& size,
                      double phase)
: camera_ (camera), size_ (size), world_from_camera_ (scene.world_from_camera (phase))
{
  // Image positions go from -0.5 to size - 0.5; half a tile more on all sides.
  columns_ = static_cast<int> (size.width / tile) + 2;
  rows_ = static_cast<int> (size.height / tile) + 2;
  tiles_.resize (static_cast<std::size_t> (columns_) * rows_);
  const Isometry camera_from_world = world_from_camera_.inverse();
  const auto index = [] (double x, int count) {
    const double i = std::floor (x / tile + 0.5);
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
  const int c = static_cast<int> (std::floor (u / tile + 0.5));
  const int r = static_cast<int> (std::floor (v / tile + 0.5));
  if (c < 0 || r < 0 || c >= columns_ || r >= rows_)
    return nearest;
  const Eigen::Vector3d ray = direction (u, v);
  for (const int p : tiles_[r * columns_ + c])
    if (parts_[p]->cast (ray, limit, nearest)) {
      nearest.part = p;
      limit = nearest.depth;
    }
  return nearest;
}

std::vector<ViewHit>
castPixels (const FrameView& view, int threads)
{
  const cv::Size size = view.size();
  std::vector<ViewHit> hits (static_cast<std::size_t> (size.area()));
  parallelFor (threads, size.height, 4, [&] (int v) {
    for (int u = 0; u < size.width; ++u)
      hits[static_cast<std::size_t> (v) * size.width + u] = view.cast (u, v);
  });
  return hits;
}

} // namespace pcl_msf::synthetic
