// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/export.h>
#include <pcl_msf/scene_flow.h>

#include <string>
#include <vector>

namespace pcl_msf::io {

// Pictures for people, CV_8UC3 (BGR), made without a display. Images that they take are
// CV_8UC1, CV_8UC3 (BGR) or empty (then a plain grey stands in, of the labels' size).

/** \brief Segments over an image: a colour each (pcl::GlasbeyLUT), dark boundaries.
 * \param labels CV_32SC1, negative = none, where the image stays as it is */
PCL_MSF_EXPORT cv::Mat
segmentOverlay (const cv::Mat& image, const cv::Mat& labels);

/** \brief Motion groups over an image: the dominant one grey, the others in colours,
 * undetermined segments black; boundaries where motion changes. */
PCL_MSF_EXPORT cv::Mat
motionOverlay (const cv::Mat& image, const SceneFlow& scene_flow);

/** \brief Visibility over an image, with a legend below: seen = the image itself,
 * occluded red, out of view blue, unknown yellow, without depth black.
 * \param visibility CV_8UC1, see Visibility */
PCL_MSF_EXPORT cv::Mat
visibilityPicture (const cv::Mat& image, const cv::Mat& visibility);

/** \brief A scalar per pixel as colours with a scale bar below.
 * \param scalar CV_32FC1, NaN = black \param maximum end of the scale; <= 0 takes the
 * 99th percentile \param unit text behind the numbers */
PCL_MSF_EXPORT cv::Mat
scalarPicture (const cv::Mat& scalar, double maximum, const std::string& unit);

/** \brief Depth as colours, near = warm, with a scale bar; equal steps in 1 / depth.
 * \param depth CV_32FC1, metres; no measurement = black */
PCL_MSF_EXPORT cv::Mat
depthPicture (const cv::Mat& depth);

/** \brief The current image as the reference sees it: pixel p holds current (p + flow).
 * \param current CV_8UC1 or CV_8UC3 \param flow CV_32FC2, pixels; NaN = black. Linear
 * interpolation, border replicated. \return the type of `current` */
PCL_MSF_EXPORT cv::Mat
warpToReference (const cv::Mat& current, const cv::Mat& flow);

/** \brief |reference - current warped by the flow| in grey levels (0 .. 255).
 * \return CV_32FC1, NaN where the flow is unknown */
PCL_MSF_EXPORT cv::Mat
brightnessResidual (const cv::Mat& reference,
                    const cv::Mat& current,
                    const cv::Mat& flow);

/** \brief |depth of the warped point - depth that the current frame has there|, metres.
 * \param current_depth CV_32FC1, metres \return CV_32FC1, NaN where either is unknown
 */
PCL_MSF_EXPORT cv::Mat
depthResidual (const SceneFlow& scene_flow, const cv::Mat& current_depth);

/** \brief Two images in two tints, the first orange, the second blue: grey where they
 * agree. */
PCL_MSF_EXPORT cv::Mat
tintedOverlay (const cv::Mat& first, const cv::Mat& second);

/** \brief Optical flow in Middlebury colours, the wheel with its length in a corner.
 * \param flow CV_32FC2, pixels, NaN = black \param maximum as in flowColors */
PCL_MSF_EXPORT cv::Mat
flowPicture (const cv::Mat& flow, double maximum = 0.0);

/** \brief Connections between segments over an image: lines between their centroids,
 * green where they move together (weight at least 0.95, as in motion groups), yellow
 * where loosely (at least 0.5), red where the connection is broken; with a legend
 * below. */
PCL_MSF_EXPORT cv::Mat
weightsPicture (const cv::Mat& image, const SceneFlow& scene_flow);

/** \brief Cost per term against iteration, on a logarithmic axis; bands show the
 * pyramid levels. \param size pixels, at least 160 x 120 */
PCL_MSF_EXPORT cv::Mat
convergencePlot (const Report& report, const cv::Size& size);

/** \brief Two pictures to be shown in turn: the reference, and the current image as the
 * reference sees it, black where the flow is unknown in both. Nothing jumps where the
 * flow is right. */
struct FlickerPair {
  cv::Mat before; ///< CV_8UC3
  cv::Mat after;  ///< CV_8UC3
};
PCL_MSF_EXPORT FlickerPair
flickerPair (const cv::Mat& reference, const cv::Mat& current, const cv::Mat& flow);

/** \brief A picture with the words to stand over it. */
struct LabelledPicture {
  std::string label;
  cv::Mat picture; ///< CV_8UC1 or CV_8UC3
};

/** \brief Tiles pictures, scaled to one width, into one overview.
 * \param columns pictures side by side, >= 1 \param width of each, pixels */
PCL_MSF_EXPORT cv::Mat
contactSheet (const std::vector<LabelledPicture>& pictures, int columns, int width);

} // namespace pcl_msf::io
