// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/export.h>
#include <pcl_msf/io/rgbd_images.h>
#include <pcl_msf/io/text_files.h>

#include <optional>
#include <string>

namespace pcl_msf::io {

/** \brief A recorded or generated RGB-D sequence in the project's folder layout.
 *
 * `color_K.png` (optional) and `depth_K.png|dpt|pfm|tiff`, or `cloud_K.pcd`, K from 0
 * on without gaps; `camera.txt` (see readCamera). Ground truth, all optional:
 * `gt/flow_0_K.flo`, `gt/scene_flow_0_K.pfm`, `gt/visible_0_K.png`, `gt/labels_0.png`,
 * `gt/labels_K.png`, `gt/pose_K.txt`. Nothing but camera.txt is read before it is asked
 * for. Every reader throws IoError for a file that is there and damaged.
 */
class PCL_MSF_EXPORT DataFolder {
public:
  DataFolder() = default;

  /** \brief Opens a folder. \throws IoError when it is none, has no frame 0, or no
   * camera.txt (clouds need none) */
  explicit DataFolder (const std::string& path);

  const std::string&
  path () const
  {
    return path_;
  }

  /** \brief Number of frames. */
  int
  frames () const
  {
    return frames_;
  }

  /** \brief What camera.txt says; none for clouds that come without. */
  const std::optional<CameraFile>&
  camera () const
  {
    return camera_;
  }

  /** \brief Paths of a frame's files; empty when there is none. */
  std::string
  colorPath (int frame) const;
  std::string
  depthPath (int frame) const;
  std::string
  cloudPath (int frame) const;

  /** \brief Reads a frame, from images or else from a cloud; images are freed from
   * the distortion that camera.txt says.
   * \param depth_scale units per metre of the depth, whatever its type, and of clouds;
   * when not given integers have camera.txt's, floats and clouds are metres
   * \throws IoError, also when sizes differ */
  RgbdImages
  frame (int frame, std::optional<double> depth_scale = {}) const;

  /** \brief The same with the distortion that the images have. */
  RgbdImages
  storedFrame (int frame, std::optional<double> depth_scale = {}) const;

  /** \brief True optical flow from frame 0. \return CV_32FC2, pixels, NaN = unknown;
   * empty when there is none */
  cv::Mat
  flow (int frame) const;

  /** \brief True displacement from frame 0. \return CV_32FC3, metres (x, y, z), NaN =
   * unknown; empty when there is none */
  cv::Mat
  sceneFlow (int frame) const;

  /** \brief Which pixels of frame 0 are seen in `frame`. \return CV_8UC1, 255 = seen;
   * empty when there is none */
  cv::Mat
  visible (int frame) const;

  /** \brief True labels of a frame. \return CV_32SC1 as in the file, -1 = none (255 in
   * an 8-bit file, 65535 in a 16-bit one); empty when there is none */
  cv::Mat
  labels (int frame = 0) const;

  /** \brief True motion of a rigid scene, frame-K point from frame-0 point. */
  std::optional<RigidPose>
  pose (int frame) const;

private:
  std::string
  truthPath (const std::string& name) const;

  std::string path_;
  std::optional<CameraFile> camera_;
  int frames_{0};
};

} // namespace pcl_msf::io
