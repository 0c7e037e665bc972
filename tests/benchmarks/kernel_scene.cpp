// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "kernel_scene.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf::benchmarks {

namespace {

constexpr kernel::Rules kRules{1.345f, 2.0f, 1.0f, 1.0f, 1.0f, 1.0f, 1.0f, 4.0f};

float
intensityAt (int x, int y)
{
  return 0.5f + 0.2f * std::sin (0.21f * static_cast<float> (x)) +
         0.2f * std::cos (0.17f * static_cast<float> (y));
}

float
depthAt (int x, int y)
{
  return 2.0f + 0.1f * std::sin (0.01f * static_cast<float> (x)) +
         0.1f * std::cos (0.013f * static_cast<float> (y));
}

} // namespace

KernelScene::KernelScene (int width, int height)
{
  const float focal = 0.82f * static_cast<float> (width);
  const float cx = 0.5f * static_cast<float> (width - 1);
  const float cy = 0.5f * static_cast<float> (height - 1);
  const std::size_t pixels = static_cast<std::size_t> (width) * height;
  texels_.reserve (2 * pixels);
  for (std::vector<float>& column : columns_)
    column.reserve (pixels + kernel::kLanes);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float z = depthAt (x, y);
      texels_.insert (texels_.end(), {intensityAt (x, y), 1.0f / z});
      const float point[10] = {(static_cast<float> (x) - cx) / focal * z,
                               (static_cast<float> (y) - cy) / focal * z,
                               z,
                               intensityAt (x + 1, y),
                               0.05f,
                               0.05f,
                               -0.997f,
                               50.0f,
                               300.0f,
                               0.02f};
      for (int i = 0; i < 10; ++i)
        columns_[i].push_back (point[i]);
    }
  for (std::vector<float>& column : columns_)
    column.resize (pixels + kernel::kLanes, 0.0f);
  offsets_.assign (pixels, 0.0f);
  active_.assign (pixels, 0);
  image_ = {texels_.data(), width, height, focal, focal, cx, cy};
  for (int i = 0; i < 9; ++i)
    motion_.rotation[i] = motion_.normal_rotation[i] = i % 4 == 0 ? 1.0 : 0.0;
  motion_.translation[0] = 0.004;
  motion_.origin[2] = 2.0;
}

kernel::Points
KernelScene::segment (int first) const
{
  const float* p[10];
  for (int i = 0; i < 10; ++i)
    p[i] = columns_[i].data() + first;
  return {p[0],
          p[1],
          p[2],
          p[3],
          p[4],
          p[5],
          p[6],
          p[7],
          p[8],
          p[9],
          std::min (kSegment, points() - first)};
}

kernel::Sums
KernelScene::linearize (const kernel::Kernel& kernel)
{
  kernel::Sums sums{};
  for (int first = 0; first < points(); first += kSegment)
    kernel.linearize (segment (first),
                      image_,
                      motion_,
                      kRules,
                      {offsets_.data() + first, active_.data() + first},
                      sums);
  return sums;
}

kernel::Sums
KernelScene::probe (const kernel::Kernel& kernel)
{
  kernel::Sums sums{};
  for (int first = 0; first < points(); first += kSegment)
    kernel.probe (segment (first), image_, motion_, kRules, sums);
  return sums;
}

} // namespace pcl_msf::benchmarks
