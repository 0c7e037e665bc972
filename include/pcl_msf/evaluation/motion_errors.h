// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/export.h>
#include <pcl_msf/io/rgbd_sequence.h>
#include <pcl_msf/rigid_pose.h>
#include <pcl_msf/scene_flow.h>

#include <vector>

namespace pcl_msf::evaluation {

/** \brief How far a pose is from the true one. */
struct PoseError {
  double rotation_deg;   ///< angle of R_estimate R_truth^T, degrees, [0, 180]
  double translation_mm; ///< distance of a point's two images, millimetres
};

/** \brief Compares two poses that both take frame a to frame b.
 * \param at the point (frame a, metres) whose images are compared: the origin for a
 * camera's motion; a segment's centroid for a segment, since far from the camera a
 * rotation error moves the origin, not the segment */
PCL_MSF_EXPORT PoseError
poseError (const RigidPose& estimate,
           const RigidPose& truth,
           const Eigen::Vector3d& at = Eigen::Vector3d::Zero());

/** \brief Pose errors of segments. Means weighted by points; all NaN for no segment. */
struct PCL_MSF_EXPORT SegmentErrors {
  int segments{0}; ///< scored: most of their labelled points are of a rigid body
  double rotation_deg;
  double translation_mm; ///< at the segments' centroids
  double median_rotation_deg;
  double median_translation_mm;

  /** \brief Of determined segments of a rigid body: the pose's squared error weighted
   * by its information matrix, mean and median. 6 and 5.3 where the information is
   * what it says. */
  double normalized_square, median_normalized_square;
  /** \brief The same of motion groups whose segments are mostly of one rigid body. */
  double groups_normalized_square;

  SegmentErrors();
};

/** \brief Scores the segments' poses against their bodies'. A segment belongs to the
 * label that most of its points bear (the lower of two that tie); undetermined segments
 * count as not moving.
 * \param labels CV_32SC1, true bodies of the reference, -1 = none
 * \throws InvalidInput for sizes that differ */
PCL_MSF_EXPORT SegmentErrors
segmentErrors (const SceneFlow& estimate,
               const cv::Mat& labels,
               const std::vector<std::optional<RigidPose>>& bodies);

/** \brief Adjusted Rand index of two partitions of pixels (Hubert and Arabie, Journal
 * of Classification 1985): 1 = the same partition, 0 = as good as chance. 1 when both
 * consist of one set or both of singletons; 0 when one of them is a single set and the
 * other is not, however small its other sets are.
 * \param first, second CV_32SC1; pixels that are negative in either are left out
 * \return NaN when fewer than two pixels are left
 * \throws InvalidInput for other types or sizes that differ */
PCL_MSF_EXPORT double
adjustedRandIndex (const cv::Mat& first, const cv::Mat& second);

/** \brief Share of the pixels that belong to their group's most frequent label: below 1
 * where a group holds points of several bodies, however much bodies are split.
 * \param groups, labels CV_32SC1; pixels that are negative in either are left out
 * \return NaN when none is left \throws InvalidInput as above */
PCL_MSF_EXPORT double
groupPurity (const cv::Mat& groups, const cv::Mat& labels);

/** \brief Motion group of each pixel. \return CV_32SC1, -1 where there is no segment */
PCL_MSF_EXPORT cv::Mat
motionGroups (const SceneFlow& estimate);

/** \brief Rigid motions that fit the true scene flow of each label best in the least
 * squares sense (Umeyama, PAMI 1991): what a perfect start would be.
 * \param labels CV_32SC1, segments 0 .. n - 1, -1 = none
 * \param points CV_32FC3, reference points, metres; not finite = none
 * \param scene_flow CV_32FC3, metres; not finite = unknown
 * \return n poses, current_from_reference; of fewer than three known points the mean
 * translation, of none rest
 * \throws InvalidInput for other types or sizes that differ */
PCL_MSF_EXPORT std::vector<RigidPose>
fitSegments (const cv::Mat& labels,
             const cv::Mat& points,
             const cv::Mat& scene_flow,
             int segments);

} // namespace pcl_msf::evaluation
