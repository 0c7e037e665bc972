// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/export.h>
#include <pcl_msf/scene_flow.h>
#include <pcl_msf/visualization/scene.h>

#include <string>
#include <utility>
#include <vector>

namespace pcl_msf::visualization {

/** \brief A result and the clouds that it is about. Images that are not known are
 * empty. */
struct ResultClouds {
  SceneFlow scene_flow;    ///< points, displacement, labels, visibility, segments
  cv::Mat reference_color; ///< CV_8UC1 or CV_8UC3 (BGR)
  cv::Mat current_points;  ///< CV_32FC3, metres, the current frame's cloud
  cv::Mat current_color;   ///< CV_8UC1 or CV_8UC3 (BGR)
};

/** \brief What a picture shows. */
enum class PictureKind {
  Before,        ///< reference and current cloud as they are, own colours
  After,         ///< warped reference and current cloud, own colours
  BeforeTints,   ///< as Before, in two contrasting tints
  AfterTints,    ///< as After, in two contrasting tints
  Warped,        ///< the warped reference alone
  Segments,      ///< segments of the reference, a colour each
  Motions,       ///< motion groups: the largest grey, the others a colour each
  Arrows,        ///< displacements, coloured by length
  Trajectories,  ///< paths of points through a window, coloured by frame
  Residual,      ///< brightness left over, on the warped cloud
  DepthResidual, ///< distance to the current surface along the line of sight
  Occlusion      ///< what is seen in both frames, and why not
};

/** \brief Kinds and their names for file names and options, e.g. "after_tints". */
PCL_MSF_EXPORT const std::vector<std::pair<std::string, PictureKind>>&
pictureKinds ();

/** \brief "after_tints", ... */
PCL_MSF_EXPORT std::string
toString (PictureKind kind);

struct SceneOptions {
  int arrow_step{0};       ///< pixels between arrows or trajectories; 0 = as many as
                           ///< fit beside each other
  double arrow_scale{0.0}; ///< arrows are so many times the displacement; 0 = 1, or 2,
                           ///< 5, 10, ... when they were too short to be seen
  double maximum{0.0};     ///< end of the colour scale; 0 = 99th percentile
};

/** \brief Builds the scene of a kind.
 * \throws InvalidInput when the result lacks what the kind shows, with the remedy (e.g.
 * no current cloud), or sizes differ. Not for Trajectories, see trajectoryScene. */
PCL_MSF_EXPORT Scene
resultScene (PictureKind kind,
             const ResultClouds& result,
             const SceneOptions& options = {});

/** \brief Paths of the reference's points through a window.
 * \param displacements CV_32FC3 of frame 1, 2, ... from the reference, metres, NaN =
 * unknown: a path ends there \throws InvalidInput as resultScene */
PCL_MSF_EXPORT Scene
trajectoryScene (const ResultClouds& result,
                 const std::vector<cv::Mat>& displacements,
                 const SceneOptions& options = {});

/** \brief The reference on its way through a window, over the current cloud when there
 * is one. \param displacements as for trajectoryScene, at least one \param t 0 = the
 * reference, k = frame k; between frames every point moves on a straight line
 * \throws InvalidInput as resultScene */
PCL_MSF_EXPORT Scene
warpScene (const ResultClouds& result,
           const std::vector<cv::Mat>& displacements,
           double t);

/** \brief A cloud's points displaced by a share. \return CV_32FC3, NaN = unknown */
PCL_MSF_EXPORT cv::Mat
displacedPoints (const cv::Mat& points, const cv::Mat& displacement, double share);

} // namespace pcl_msf::visualization
