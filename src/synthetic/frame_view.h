// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <synthetic/part_view.h>

#include <limits>
#include <memory>
#include <vector>

namespace pcl_msf::synthetic {

/** \brief Which place of an ideal image a pixel of the sensor sees. */
struct Lens {
  LensDistortion distortion{};
  Eigen::Vector2d shift{0.0, 0.0}; ///< of what is shown, pixels

  bool
  isNone () const
  {
    return distortion.isNone() && shift.x() == 0.0 && shift.y() == 0.0;
  }

  Eigen::Vector2d
  idealPixel (const PinholeCamera& camera, double u, double v) const
  {
    return distortion.undistortedPixel (camera, u - shift.x(), v - shift.y());
  }
};

/** \brief A scene as the camera sees it at one moment, through a lens. Refers to the
 * scene, which must outlive it. Thread-safe. */
class FrameView {
public:
  FrameView (const SceneModel& scene,
             const PinholeCamera& camera,
             const cv::Size& size,
             double phase,
             const Lens& lens = {});

  /** \brief The nearest hit of the ray through an image position, in pixels. */
  ViewHit
  cast (double u,
        double v,
        double limit = std::numeric_limits<double>::infinity()) const;

  /** \brief Direction with z = 1 through an image position. */
  Eigen::Vector3d
  direction (double u, double v) const
  {
    const Eigen::Vector2d ideal = idealPixel (u, v);
    return camera_.backProject (ideal.x(), ideal.y(), 1.0);
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
  Eigen::Vector2d
  idealPixel (double u, double v) const
  {
    return straight_ ? Eigen::Vector2d (u, v) : lens_.idealPixel (camera_, u, v);
  }

  PinholeCamera camera_;
  cv::Size size_;
  Lens lens_;
  bool straight_; ///< the lens changes nothing
  double border_; ///< how far outside the image the lens sees, pixels
  Isometry world_from_camera_;
  std::vector<std::unique_ptr<PartView>> parts_;
  int columns_{0}, rows_{0};
  std::vector<std::vector<int>> tiles_; ///< parts that may cover an image square
};

/** \brief What the rows of one image see: all the same moment, or with a rolling
 * shutter some rows each. */
class ImageViews {
public:
  /** \brief One moment. Refers to the view, which must outlive it. */
  ImageViews (const FrameView& view) // implicit: a view is an image
  : size_ (view.size()), first_ (&view)
  {}

  /** \param views from top to bottom, for the same number of rows each */
  explicit ImageViews (std::vector<std::unique_ptr<const FrameView>> views);

  const FrameView&
  row (int v) const
  {
    return views_.empty() ? *first_ : *views_[v * views_.size() / size_.height];
  }
  const cv::Size&
  size () const
  {
    return size_;
  }

private:
  cv::Size size_;
  const FrameView* first_;
  std::vector<std::unique_ptr<const FrameView>> views_;
};

/** \brief Hits at all pixel centres, row by row. \param threads > 0 */
std::vector<ViewHit>
castPixels (const ImageViews& views, int threads);

} // namespace pcl_msf::synthetic
