// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <opencv2/core.hpp>

#include <pcl_msf/build_compatibility.h>
#include <pcl_msf/pinhole_camera.h>

#include <string>
#include <vector>

namespace pcl_msf {

/* From PCL's organized clouds to the images that the method works on. All images have
 * the cloud's width and height; pixel (u, v) is point v * width + u. */

/** \brief Throws unless the cloud is an image: height > 1 and width * height points.
 * \param[in] name what to call the cloud in the message, e.g. "source"
 * \throws InvalidInput naming the remedy */
template <typename PointT>
void
requireOrganized (const pcl::PointCloud<PointT>& cloud, const std::string& name);

/** \brief Coordinates. \return CV_32FC3 (x, y, z), metres, as they are in the cloud;
 * NaN in all three where a coordinate is not finite or z is not positive
 * \throws InvalidInput when the cloud is not organized */
template <typename PointT>
cv::Mat
pointImage (const pcl::PointCloud<PointT>& cloud);

/** \brief Colour, by the fields that the point type has.
 * \return CV_8UC3 (B, G, R) for rgb or rgba; CV_32FC1 for intensity, in the cloud's own
 * unit (see normalizeIntensity), 0 where it is not finite; an empty image for other
 * types \throws InvalidInput when the cloud is not organized */
template <typename PointT>
cv::Mat
colorImage (const pcl::PointCloud<PointT>& cloud);

/** \brief Depth of a point image. \return CV_32FC1, metres, NaN = no measurement */
cv::Mat
depthImage (const cv::Mat& points);

/** \brief Brings raw intensity images to [0, 1] by one factor, so that equal values
 * stay equal: none when the largest maximum is at most 1, 1/255 when it is at most 255,
 * one over that maximum above. Negative values become 0. All are left alone when one is
 * of another type or empty. */
void
normalizeIntensity (const std::vector<cv::Mat*>& images);

/** \brief As above, for two images. */
void
normalizeIntensity (cv::Mat& first, cv::Mat& second);

/** \brief Normals. \return CV_32FC3 (x, y, z), unit length as given; NaN stays NaN
 * \throws InvalidInput when the cloud is not organized */
cv::Mat
normalImage (const pcl::PointCloud<pcl::Normal>& normals);

/** \brief Segment labels. \return CV_32SC1; labels above 2^31 - 1 (PCL marks "none" by
 * the largest number) become -1 = no segment. 0 is a label like any other. \throws
 * InvalidInput when the cloud is not organized */
cv::Mat
labelImage (const pcl::PointCloud<pcl::Label>& labels);

/** \brief Root mean square distance between the points' projections (Eq. 2) and their
 * pixels. \return pixels; NaN without valid points */
double
projectionError (const cv::Mat& points, const PinholeCamera& camera);

/** \brief The pinhole camera of an organized cloud in its own optical frame.
 *
 * With u = fx x/z + cx and v = fy y/z + cy each axis is a straight-line fit. It has
 * four unknowns where pcl::estimateProjectionMatrix has eleven, needs no particular
 * geometry (that one fails on planes) and cannot answer with a rotated camera.
 * \param[in] points as from pointImage
 * \param[out] camera pixels; untouched on failure
 * \param[out] why when not null: what is wrong and the remedy
 * \return false when the points fix no valid camera or miss their pixels by more than 1
 * pixel root mean square: not a pinhole image, or not in the camera's frame */
bool
estimateCamera (const cv::Mat& points,
                PinholeCamera& camera,
                std::string* why = nullptr);

} // namespace pcl_msf

#include <pcl_msf/impl/cloud_conversions.hpp>
