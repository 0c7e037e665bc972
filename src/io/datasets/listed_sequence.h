// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/io/rgbd_sequence.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace pcl_msf::io {

/** \brief Where a frame comes from. */
struct FrameFiles {
  std::string color; ///< empty = geometry only
  std::string depth;
  PinholeCamera camera;
  double timestamp{std::numeric_limits<double>::quiet_NaN()}; ///< seconds
  std::optional<RigidPose> world_from_camera;
  LensDistortion distortion{}; ///< of the images, which are freed from it
  int number{-1}; ///< in the data set's names: truth leads from one to the next
};

/** \brief A sequence whose frames are a colour and a depth file each. */
class ListedSequence : public RgbdSequence {
public:
  /** \param depth_scale integer units per metre \param size that all images must have;
   * empty = any \param float_scale float units per metre */
  ListedSequence (std::string name,
                  std::vector<FrameFiles> files,
                  double depth_scale,
                  const cv::Size& size = {},
                  double float_scale = 1.0);

  std::string
  name () const override;

  int
  frames () const override;

  RgbdImages
  frame (int k) const override;

  double
  timestamp (int k) const override;

  std::optional<RigidPose>
  cameraPose (int k) const override;

protected:
  /** \brief Depth of a frame, metres. */
  virtual cv::Mat
  depth (const FrameFiles& files) const;

  /** \throws InvalidInput for a frame that there is not */
  const FrameFiles&
  files (int k) const;

  /** \brief Is `to` the next recorded frame after `from`, without a gap? */
  bool
  follows (int from, int to) const;

  /** \brief Size of frame k's images. */
  cv::Size
  imageSize (int k) const;

private:
  std::string name_;
  std::vector<FrameFiles> files_;
  double depth_scale_;
  cv::Size size_;
  double float_scale_;
};

} // namespace pcl_msf::io
