// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <opencv2/core.hpp>

#include <pcl_msf/build_compatibility.h>
#include <pcl_msf/export.h>
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

/** \brief Coordinates, with those behind the camera, too: what fitsCamera and
 * estimateCamera tell another frame by. \return CV_32FC3 (x, y, z), metres, as they are
 * in the cloud; NaN in all three where a coordinate is not finite
 * \throws InvalidInput when the cloud is not organized */
template <typename PointT>
cv::Mat
coordinateImage (const pcl::PointCloud<PointT>& cloud);

/** \brief Colour, by the fields that the point type has.
 * \return CV_8UC3 (B, G, R) for rgb or rgba; CV_32FC1 for intensity, in the cloud's own
 * unit (see normalizeIntensity), 0 where it is not finite; an empty image for other
 * types \throws InvalidInput when the cloud is not organized */
template <typename PointT>
cv::Mat
colorImage (const pcl::PointCloud<PointT>& cloud);

/** \brief Depth of a point image. \return CV_32FC1, metres, NaN = no measurement */
PCL_MSF_EXPORT cv::Mat
depthImage (const cv::Mat& points);

/** \brief The unit that raw intensity images share: 1, 2 (floats with gain), 255, or
 * the next of 511, 1023, 2047, ... that 95 % of each image's positive values stay
 * below. So neither a few highlights nor pixels without a measurement have a say, and
 * images up to 1 and up to 255 keep those units. \param[in] images CV_32FC1, any unit;
 * values that are not finite or not positive don't count. \return 1 when one is of
 * another type or empty \throws InvalidInput when one image is in shares of 1, another
 * in tens or hundreds: no exposure explains that */
PCL_MSF_EXPORT double
intensityUnit (const std::vector<cv::Mat*>& images);

/** \brief Brings raw intensity images to [0, 1] by one over their common
 * intensityUnit, so that equal values stay equal: all images that are compared must go
 * in together. Highlights above the unit become 1, negative values and those that are
 * not finite 0. All are left alone when one is of another type or empty. */
PCL_MSF_EXPORT void
normalizeIntensity (const std::vector<cv::Mat*>& images);

/** \brief As above, with a unit known before: a stream keeps the one that it began
 * with. \param[in] unit > 0 */
PCL_MSF_EXPORT void
normalizeIntensity (const std::vector<cv::Mat*>& images, double unit);

/** \brief As above, for two images. */
PCL_MSF_EXPORT void
normalizeIntensity (cv::Mat& first, cv::Mat& second);

/** \brief Normals. \return CV_32FC3 (x, y, z), unit length as given; NaN stays NaN
 * \throws InvalidInput when the cloud is not organized */
PCL_MSF_EXPORT cv::Mat
normalImage (const pcl::PointCloud<pcl::Normal>& normals);

/** \brief Segment labels. \return CV_32SC1; labels above 2^31 - 1 (PCL marks "none" by
 * the largest number) become -1 = no segment. 0 is a label like any other. \throws
 * InvalidInput when the cloud is not organized */
PCL_MSF_EXPORT cv::Mat
labelImage (const pcl::PointCloud<pcl::Label>& labels);

/** \brief Root mean square distance between the projections (Eq. 2) of the points with
 * z > 0 and their pixels. \return pixels; NaN without such points */
PCL_MSF_EXPORT double
projectionError (const cv::Mat& points, const PinholeCamera& camera);

/** \brief Are the points an image of the camera, in its optical frame?
 *
 * Judged by the median distance of their projections from their pixels, so that a few
 * wild points (edges after a filter) do no harm: at most 2 pixels. Half-pixel
 * conventions, a rounded principal point and what calibration leaves of a lens stay
 * below; mirrored, turned or moved clouds and another sensor's camera miss by tens.
 * \param[in] points as from coordinateImage; from pointImage the cause is told less
 * well \param[out] why when not null and the answer is no: the distance, the cause
 * where the points tell it (mirrored or exchanged axes, a rotation, an offset, another
 * camera), the remedy */
PCL_MSF_EXPORT bool
fitsCamera (const cv::Mat& points,
            const PinholeCamera& camera,
            std::string* why = nullptr);

/** \brief The pinhole camera of an organized cloud in its own optical frame.
 *
 * With u = fx x/z + cx and v = fy y/z + cy each axis is a straight-line fit. It has
 * four unknowns where pcl::estimateProjectionMatrix has eleven, needs no particular
 * geometry (that one fails on planes) and cannot answer with a rotated camera. Where
 * least squares miss by more than 1 pixel root mean square, as with wild edge points
 * after a filter, lines that those cannot move take their place.
 * \param[in] points as from coordinateImage; from pointImage the cause is told less
 * well \param[out] camera pixels; untouched on failure \param[out] why when not null:
 * what is wrong, the cause as in fitsCamera, the remedy \return false when the points
 * fix no valid camera or half of them miss their pixels by more than 1: not a pinhole
 * image, or not in the camera's frame */
PCL_MSF_EXPORT bool
estimateCamera (const cv::Mat& points,
                PinholeCamera& camera,
                std::string* why = nullptr);

} // namespace pcl_msf

#include <pcl_msf/impl/cloud_conversions.hpp>
