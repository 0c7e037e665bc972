// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <synthetic/frame_view.h>

#include <vector>

namespace pcl_msf::synthetic {

/** \brief Draws supersampled colour. Refers to the scene, which must outlive it. */
class ColorRenderer {
public:
  ColorRenderer (const SceneModel& scene, unsigned seed, int supersampling);

  /** \param hits of all pixel centres of the views
   * \return CV_32FC3, BGR, 0 .. 255 and somewhat beyond */
  cv::Mat
  render (const ImageViews& views, const std::vector<ViewHit>& hits, int threads) const;

private:
  Eigen::Vector3f
  pixelColor (const FrameView& view,
              const std::vector<ViewHit>& hits,
              int u,
              int v) const;

  Eigen::Vector3f
  smoothPixel (const FrameView& view, const ViewHit& hit, int u, int v) const;

  Eigen::Vector3f
  edgePixel (const FrameView& view, int u, int v) const;

  Eigen::Vector3f
  hitColor (const FrameView& view,
            const ViewHit& hit,
            const Eigen::Vector3d& direction) const;

  float
  shade (const Part& part,
         int index,
         const ViewHit& hit,
         const PartView& view,
         Eigen::Vector3f& normal) const;

  Eigen::Vector3f
  skyColor (const FrameView& view, const Eigen::Vector3d& direction) const;

  double
  offset (int sample) const
  {
    return (sample + 0.5) / supersampling_ - 0.5;
  }

  const SceneModel& scene_;
  LatticeNoise noise_;
  int supersampling_;
  std::vector<Eigen::Vector3d> lights_; ///< per part, its coordinates at phase 0
};

} // namespace pcl_msf::synthetic
