// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/data/data_kernel.h"

#include <cstdint>
#include <vector>

namespace pcl_msf::benchmarks {

/** \brief What a kernel does per point, counted in its source; an addition, a product,
 * a comparison or a choice counts one. */
struct KernelWork {
  double operations;
  double bytes; ///< read and written, the image once
};

constexpr KernelWork kLinearizeWork{320.0, 53.0};
constexpr KernelWork kProbeWork{160.0, 48.0};

/** \brief Points of a wavy, textured surface and an image of it from a little aside,
 * for the kernels alone. */
class KernelScene {
public:
  KernelScene (int width, int height);

  int
  points () const
  {
    return static_cast<int> (columns_[0].size()) - kernel::kLanes;
  }

  /** \brief All points once, in segments of kSegment points. \return sums of all */
  kernel::Sums
  linearize (const kernel::Kernel& kernel);
  kernel::Sums
  probe (const kernel::Kernel& kernel);

private:
  static constexpr int kSegment = 600; ///< of 512 segments at 640x480

  kernel::Points
  segment (int first) const;

  std::vector<float> texels_;
  std::vector<float> columns_[10]; ///< in the order of kernel::Points
  std::vector<float> offsets_;
  std::vector<std::uint8_t> active_;
  kernel::Image image_;
  kernel::Motion motion_{};
};

} // namespace pcl_msf::benchmarks
