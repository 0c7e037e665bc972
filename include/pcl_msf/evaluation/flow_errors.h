// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/export.h>

#include <vector>

namespace pcl_msf::evaluation {

/** \brief Which points of the reference are scored; only those with depth are. */
enum class ScoredPoints {
  All,
  Visible, ///< seen in both frames
  Occluded ///< hidden in the current frame, or out of its view
};

/** \brief The mask of a set of points.
 * \param depth CV_32FC1, metres; not > 0 or not finite = no measurement
 * \param visible CV_8UC1, 255 = seen in both frames; empty = unknown: all points count
 * as visible, none as occluded
 * \return CV_8UC1, 255 = scored, 0 otherwise
 * \throws InvalidInput for other types or sizes that differ */
PCL_MSF_EXPORT cv::Mat
scoredPoints (const cv::Mat& depth, const cv::Mat& visible, ScoredPoints set);

/** \brief Errors of an optical flow over a set of points; all NaN when it is empty. */
struct PCL_MSF_EXPORT FlowErrors {
  long points{0};  ///< scored: in the mask, with known truth
  double coverage; ///< share of them with a known estimate, [0, 1]
  double epe;      ///< mean end-point error, pixels
  double median;   ///< of the end-point error, pixels
  double rms;      ///< root mean square end-point error, pixels
  double angle;    ///< mean angular error, degrees, [0, 180]
  double outliers; ///< share with an error > 3 pixels and > 5 % of the true length

  FlowErrors();
};

/** \brief Scores an optical flow.
 *
 * End-point error: length of the difference. Angular error: angle between (u, v, 1) of
 * estimate and truth (Barron, Fleet and Beauchemin, IJCV 1994; Baker et al., IJCV
 * 2011). Outliers: as KITTI 2015 counts them (Menze and Geiger, CVPR 2015).
 *
 * An unknown estimate counts as zero motion: leaving points out must not pay.
 * \param flow, truth CV_32FC2, pixels (u, v); not finite = unknown
 * \param mask CV_8UC1, 255 = scored
 * \throws InvalidInput for other types or sizes that differ */
PCL_MSF_EXPORT FlowErrors
flowErrors (const cv::Mat& flow, const cv::Mat& truth, const cv::Mat& mask);

/** \brief End-point error of every pixel, as flowErrors() counts it.
 * \return CV_32FC1, pixels; NaN where the truth is unknown
 * \throws InvalidInput for other types or sizes that differ */
PCL_MSF_EXPORT cv::Mat
endPointErrors (const cv::Mat& flow, const cv::Mat& truth);

/** \brief How well a deviation sorts errors: the area between two sparsification
 * curves, that of the deviation and that of the errors themselves (AUSE: Ilg et al.,
 * Uncertainty Estimates and Multi-Hypotheses Networks for Optical Flow, ECCV 2018). A
 * curve is the mean error of the points that remain when the least sure ones are taken
 * away, as a share of the mean of all, against the share that is taken away.
 * \param errors CV_32FC1; not finite = unknown
 * \param deviation CV_32FC1, any unit; not finite = least sure
 * \param mask CV_8UC1, 255 = scored
 * \return 0 = in the errors' own order; NaN without points or errors
 * \throws InvalidInput for other types or sizes that differ */
PCL_MSF_EXPORT double
sparsificationError (const cv::Mat& errors,
                     const cv::Mat& deviation,
                     const cv::Mat& mask);

/** \brief Errors of displacements over a set of points; all NaN when it is empty. */
struct PCL_MSF_EXPORT SceneFlowErrors {
  long points{0};   ///< scored: in the mask, with known truth
  double coverage;  ///< share of them with a known estimate, [0, 1]
  double epe;       ///< mean length of the difference, metres
  double median;    ///< of it, metres
  double rms;       ///< root mean square, metres
  double under_5cm; ///< share with an error < 0.05 m
  double under_1cm; ///< share with an error < 0.01 m

  SceneFlowErrors();
};

/** \brief Scores displacements; an unknown estimate counts as zero motion.
 * \param displacement, truth CV_32FC3, metres (x, y, z); not finite = unknown
 * \param mask CV_8UC1, 255 = scored
 * \throws InvalidInput for other types or sizes that differ */
PCL_MSF_EXPORT SceneFlowErrors
sceneFlowErrors (const cv::Mat& displacement,
                 const cv::Mat& truth,
                 const cv::Mat& mask);

/** \brief Mean of a list; NaN when it is empty. */
PCL_MSF_EXPORT double
mean (const std::vector<double>& values);

/** \brief Median of a list, for an even number the mean of the middle two; NaN when it
 * is empty. */
PCL_MSF_EXPORT double
median (std::vector<double> values);

} // namespace pcl_msf::evaluation
