// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <synthetic/part_view.h>

#include <limits>
#include <memory>
#include <vector>

namespace pcl_msf::synthetic {

/** \brief A scene as the camera sees it at one moment. Refers to the scene, which must
 * outlive it. Thread-safe. */
class FrameView {
public:
  FrameView (const SceneModel& scene,
             const PinholeCamera& camera,
             const cv::Size& size,
             double phase);

  /** \brief The nearest hit of the ray through an image position, in pixels. */
  ViewHit
  cast (double u,
        double v,
        double limit = std::numeric_limits<double>::infinity()) const;

  /** \brief Direction with z = 1 through an image position. */
  Eigen::Vector3d
  direction (double u, double v) const
  {
    return camera_.backProject (u, v, 1.0);
  }

  const PartView&
  part (int index) const
  {
    return *parts_[index];
  }
  const Isometry&
  worldFromCamera () const
  {
    return world_from_camera_;
  }
  const PinholeCamera&
  camera () const
  {
    return camera_;
  }
  const cv::Size&
  size () const
  {
    return size_;
  }

private:
  PinholeCamera camera_;
  cv::Size size_;
  Isometry world_from_camera_;
  std::vector<std::unique_ptr<PartView>> parts_;
  int columns_{0}, rows_{0};
  std::vector<std::vector<int>> tiles_; ///< parts that may cover an image square
};

/** \brief Hits at all pixel centres, row by row. \param threads > 0 */
std::vector<ViewHit>
castPixels (const FrameView& view, int threads);

} // namespace pcl_msf::synthetic
