// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/export.h>
#include <pcl_msf/pinhole_camera.h>

namespace pcl_msf::evaluation {

/** \brief What a motion leaves unexplained in the images: a score without truth. It
 * misleads where there is no texture, and where hidden points find a likeness. */
struct PhotometricResiduals {
  long points{0}; ///< in the mask
  double mean;    ///< grey levels of 255; NaN without points
  double median;  ///< likewise
};

/** \brief |I0 - I1 warped by the flow|, bilinear; the image border is replicated and
 * unknown flow counts as zero flow.
 * \param flow CV_32FC2, pixels \param reference, current CV_8UC1 or CV_8UC3 (BGR)
 * \param mask CV_8UC1, 255 = scored
 * \throws InvalidInput for other types or sizes that differ */
PCL_MSF_EXPORT PhotometricResiduals
photometricResiduals (const cv::Mat& flow,
                      const cv::Mat& reference,
                      const cv::Mat& current,
                      const cv::Mat& mask);

/** \brief Distance of moved points from the current frame's surface along z. */
struct DepthResiduals {
  long points{0}; ///< in the mask, landing where the current frame has depth
  double mean;    ///< metres; NaN without points
  double median;  ///< metres
  double
      median_sigmas; ///< in standard deviations of the sensor; NaN for noise < 1e-5 / m
};

/** \brief |z of the moved point - depth of the current frame where it lands|.
 *
 * The current depth is interpolated bilinearly in inverse depth on one surface (four
 * neighbours within 5 %), otherwise taken from the nearest pixel. Unknown displacement
 * counts as zero motion.
 * \param points, displacement CV_32FC3, metres; points not finite = no measurement
 * \param current_depth CV_32FC1, metres \param camera of the current frame
 * \param inverse_depth_noise standard deviation of 1 / z, 1 / metres, see
 * RgbdFrame::inverseDepthNoise
 * \param mask CV_8UC1, 255 = scored
 * \throws InvalidInput for other types or sizes that differ */
PCL_MSF_EXPORT DepthResiduals
depthResiduals (const cv::Mat& points,
                const cv::Mat& displacement,
                const cv::Mat& current_depth,
                const PinholeCamera& camera,
                double inverse_depth_noise,
                const cv::Mat& mask);

/** \brief Depth of an image between its pixels, metres; 0 where there is none.
 * \param depth CV_32FC1 \param u, v pixels; not finite or outside gives 0 */
PCL_MSF_EXPORT float
depthAt (const cv::Mat& depth, float u, float v);

} // namespace pcl_msf::evaluation
