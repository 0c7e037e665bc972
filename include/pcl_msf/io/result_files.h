// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/export.h>
#include <pcl_msf/io/rgbd_images.h>
#include <pcl_msf/scene_flow.h>

#include <string>

namespace pcl_msf::io {

/** \brief Writes a result as a binary, organized .pcd with the fields `x y z rgb dx dy
 * dz label visible flow_deviation displacement_deviation` of
 * pcl_msf::PointXYZRGBFlow; NaN where there is no depth.
 * \param color of the reference, CV_8UC1, CV_8UC3 (BGR) or empty = white
 * \param viewpoint of the reference \throws IoError */
PCL_MSF_EXPORT void
writeSceneFlowCloud (const std::string& path,
                     const SceneFlow& scene_flow,
                     const cv::Mat& color,
                     const Viewpoint& viewpoint = {});

/** \brief Writes the warped reference as a binary, organized .pcd with x y z rgb: the
 * reference's colours at the warped positions (current frame, metres), NaN where they
 * are unknown. \param viewpoint of the reference \throws IoError */
PCL_MSF_EXPORT void
writeWarpedCloud (const std::string& path,
                  const SceneFlow& scene_flow,
                  const cv::Mat& color,
                  const Viewpoint& viewpoint = {});

/** \brief A scene flow as a file holds it. */
struct StoredSceneFlow {
  SceneFlow scene_flow;  ///< without poses, connections and report
  cv::Mat color;         ///< of the reference, CV_8UC3 (BGR); empty when all are white
  Viewpoint viewpoint{}; ///< of the reference
};

/** \brief Reads what writeSceneFlowCloud wrote.
 *
 * The camera comes from the points, the optical flow from camera and displacement, the
 * segments are counted; points that are not seen in both frames are
 * Visibility::Unknown, because the file does not say why. Deviations are empty when the
 * file has none, as those of earlier versions. \throws IoError */
PCL_MSF_EXPORT StoredSceneFlow
readSceneFlowCloud (const std::string& path);

/** \brief Motion group of every pixel. \return CV_32SC1, -1 = none */
PCL_MSF_EXPORT cv::Mat
groupImage (const SceneFlow& scene_flow);

/** \brief Gives the segments the motion groups of an image that groupImage made: each
 * the group of its first pixel. \throws InvalidInput when the sizes differ */
PCL_MSF_EXPORT void
setGroups (const cv::Mat& groups, SceneFlow& scene_flow);

[[deprecated ("use groupImage")]] inline cv::Mat
bodyImage (const SceneFlow& scene_flow)
{
  return groupImage (scene_flow);
}

[[deprecated ("use setGroups")]] inline void
setBodies (const cv::Mat& groups, SceneFlow& scene_flow)
{
  setGroups (groups, scene_flow);
}

/** \brief Visibility as the mask that is written. \param visibility CV_8UC1, see
 * Visibility \return CV_8UC1, 255 = seen in both frames, 0 otherwise */
PCL_MSF_EXPORT cv::Mat
visibilityMask (const cv::Mat& visibility);

/** \brief Times of a run that the result's Report does not hold, seconds. */
struct RunSeconds {
  double total{0.0}; ///< load to result, without writing
  double load{0.0};
  double frame{0.0};
  double segment{0.0};
  double write{0.0}; ///< all files but the report itself
};

/** \brief A result's report as JSON text; numbers that are not finite become null.
 * \param frames number of frames of the run \param removed distortion that the frames
 * were freed from before: "camera" is the pinhole without it */
PCL_MSF_EXPORT std::string
reportJson (const SceneFlow& scene_flow,
            const RunSeconds& seconds,
            int frames = 2,
            const LensDistortion& removed = {});

/** \brief Writes `reportJson` to a file. \throws IoError */
PCL_MSF_EXPORT void
writeReport (const std::string& path,
             const SceneFlow& scene_flow,
             const RunSeconds& seconds,
             int frames = 2,
             const LensDistortion& removed = {});

} // namespace pcl_msf::io
