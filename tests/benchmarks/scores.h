// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/io/data_folder.h>
#include <pcl_msf/scene_flow.h>

#include <vector>

namespace pcl_msf::benchmark {

/** \brief Median of a list; NaN when it is empty. */
double
median (std::vector<double> values);

/** \brief Mean and median of errors. */
struct Errors {
  double mean;
  double median;
};

/** \brief End-point errors (pixels) over points that are seen in both frames. Unknown
 * flow counts as zero flow: leaving points out must not pay.
 * \param visible CV_8UC1 or empty */
Errors
endPointErrors (const cv::Mat& flow,
                const cv::Mat& truth,
                const cv::Mat& visible,
                const cv::Mat& depth);

/** \brief Mean 3D error, millimetres, over the same points. */
double
meanError3d (const cv::Mat& displacement,
             const cv::Mat& truth,
             const cv::Mat& visible,
             const cv::Mat& depth);

/** \brief |I0 - I1 warped by the flow| in grey levels of 255, over points with depth
 * and, when given, only those with mask 255; the image border is replicated. */
Errors
brightnessResiduals (const cv::Mat& flow,
                     const io::RgbdImages& reference,
                     const io::RgbdImages& current,
                     const cv::Mat& mask = {});

/** \brief OpenCV's DIS optical flow, medium preset. CV_32FC2; empty without colour. */
cv::Mat
disFlow (const io::RgbdImages& reference, const io::RgbdImages& current);

} // namespace pcl_msf::benchmark
