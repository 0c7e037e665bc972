// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/io/datasets.h>

#include <string>

namespace pcl_msf::io {

/** \brief What to say about a frame that a sequence does not have. */
std::string
noSuchFrame (const std::string& sequence, int frame, int frames);

/** \brief \throws IoError naming the file and both sizes unless the image has the size
 * that is expected; an empty size expects nothing */
void
requireSize (const std::string& path, const cv::Mat& image, const cv::Size& size);

/** \brief Puts a frame together, freed from its distortion. \param color_path may be
 * empty = geometry only
 * \throws IoError when colour and depth differ in size or the camera is none for it */
RgbdImages
makeFrame (const std::string& color_path,
           const std::string& depth_path,
           const cv::Mat& depth,
           const PinholeCamera& camera,
           const LensDistortion& distortion = {});

/** \brief A three-channel 16-bit image, blue first. \param field what it is, for the
 * error \throws IoError for any other image */
cv::Mat
readDeepColor (const std::string& path, const std::string& field);

/** \brief Metres from pixels of disparity, z = focal length x baseline / (d + offset).
 * \param disparity CV_32FC1; not > 0 or not finite = unknown \return CV_32FC1, NaN =
 * unknown */
cv::Mat
depthFromDisparity (const cv::Mat& disparity,
                    double focal_times_baseline,
                    double offset = 0.0);

/** \brief What a camera is taken from: the caller's choice, or else a folder's
 * camera.txt, or else what is known of the data set. */
struct CameraChoice {
  PinholeCamera camera;
  LensDistortion distortion{}; ///< of the images
  double depth_scale{0.0};     ///< integer units per metre; 0 = unknown
  cv::Size size;               ///< of the images; empty = any
  double float_scale{1.0};     ///< of float depth and of clouds, units per metre
};

/** \brief \throws IoError for a damaged camera.txt */
CameraChoice
chooseCamera (const std::string& folder,
              const DatasetOptions& options,
              const CameraChoice& known);

} // namespace pcl_msf::io
