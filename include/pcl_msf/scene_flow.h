// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/build_compatibility.h>
#include <pcl_msf/export.h>
#include <pcl_msf/pinhole_camera.h>
#include <pcl_msf/rigid_pose.h>

#include <string>
#include <vector>

namespace pcl_msf {

/** \brief How well a segment's motion is known. */
enum class MotionStatus {
  Determined,  ///< by its own points
  Supported,   ///< its points leave a freedom, or are hidden; neighbours decide
  Undetermined ///< neither its points nor neighbours say anything
};

/** \brief The rigid motion of one segment and how well it is known. */
struct SegmentMotion {
  RigidPose current_from_reference; ///< T_k: reference point to current frame

  /** \brief Inverse covariance of the error of the six pose parameters (radians,
   * metres): of the rigid body that the segment moves with, by all of its points, and
   * of what else the segment may move with. See SceneFlow. Zero when undetermined. */
  Matrix6 information{Matrix6::Zero()};
  int rank{0}; ///< freedoms that the segment's own points determine, 0 .. 6
  MotionStatus status{MotionStatus::Undetermined};
  int points{0};         ///< points with depth
  int visible_points{0}; ///< of those, seen in the current frame, too
  union {
    int group{-1}; ///< motion group: one rigid body, or several that the optimization
                   ///< kept connected; 0 has most visible points
    [[deprecated ("use group")]] int body;
  };
  Eigen::Vector3d centroid{Eigen::Vector3d::Zero()}; ///< reference frame, metres
};
static_assert (alignof (SegmentMotion) == alignof (double) &&
               sizeof (SegmentMotion) == sizeof (double[6 + 36 + 3]) + sizeof (int[6]));

/** \brief The motion of a group of segments that move together. */
struct GroupMotion {
  RigidPose current_from_reference;     ///< of its largest rigid body
  Matrix6 information{Matrix6::Zero()}; ///< of these six parameters, as a segment's
  int segments{0};                      ///< in the group
};

/** \brief Two neighbouring segments and the strength of their connection. */
struct SegmentPair {
  int first{0};
  int second{0};
  double weight{1.0}; ///< w_{j,h} of Eq. 10 and 11: 1 = move together, 0 = independent
  double mixing{1.0}; ///< [0, 1]: how much the points between both centres follow a
                      ///< mean of both motions; 1 on a soft surface, 0 at an edge
};

/** \brief What a point's visibility image holds: the moved point against the surface
 * that the current frame shows where it lands.
 *
 * "At" the surface is within its noise: five deviations of both frames' own estimate
 * and what the motion model leaves, or of what the residuals of the solved frames show
 * when that is more, never above a tenth of the depth. A measurement among others that
 * all disagree is no surface. */
enum class Visibility : unsigned char {
  NoDepth = 0,    ///< no measurement in the reference
  OutOfView = 64, ///< leaves the image
  Occluded = 128, ///< behind the current frame's surface
  Unknown = 192, ///< not seen: the motion is undetermined, or where the point lands the
                 ///< current frame has no depth, no surface, or only a farther one
  Visible = 255  ///< at the current frame's surface: seen in both frames
};

/** \brief What a pixel of a visibility image holds, for OpenCV's functions:
 * `flow.visibility == pixelValue (Visibility::Visible)` is a mask. */
constexpr unsigned char
pixelValue (Visibility visibility)
{
  return static_cast<unsigned char> (visibility);
}

/** \brief A pixel of a visibility image, a number, against a Visibility. */
constexpr bool
operator== (int pixel, Visibility visibility)
{
  return pixel == pixelValue (visibility);
}
constexpr bool
operator== (Visibility visibility, int pixel)
{
  return pixel == pixelValue (visibility);
}
constexpr bool
operator!= (int pixel, Visibility visibility)
{
  return pixel != pixelValue (visibility);
}
constexpr bool
operator!= (Visibility visibility, int pixel)
{
  return pixel != pixelValue (visibility);
}

/** \brief Why the optimization ended. */
enum class StopReason {
  NotRun,
  Converged,         ///< the energy changes less than the tolerance
  IterationLimit,    ///< maximum number of iterations
  TimeLimit,         ///< time budget used up; the result is the best so far
  Cancelled,         ///< by the progress callback; the result is the best so far
  InvalidInput,      ///< see Report::message
  NumericalFailure,  ///< the solver could not make a step
  NothingDetermined, ///< no segment's motion could be determined: all motion is unknown
  DifferentPlaces ///< the frames show different places: hardly any of the reference, or
                  ///< of its texture, is found in the current frame
};

/** \brief "converged", "iteration_limit", ... */
PCL_MSF_EXPORT const char*
toString (StopReason reason);

/** \brief Energy (Eq. 5 or 13), by term; weighted and normalized. */
struct EnergyCost {
  double brightness{0.0};
  double icp{0.0};
  double regularizer{0.0};
  double prior{0.0};
  double concatenation{0.0}; ///< Eq. 14; 0 for two frames
  double flow{0.0}; ///< of optical flow, a guide at coarse levels; 0 at the finest
  double
  total () const
  {
    return brightness + icp + regularizer + prior + concatenation + flow;
  }
};

/** \brief One iteration, for convergence plots. */
struct IterationRecord {
  int level{0};
  double cost{0.0};
  double seconds{0.0};
  EnergyCost terms; ///< of the state after the step, by term
  int energy{0};    ///< costs compare between steps of the same number only: a level,
                    ///< rigid bodies' own noise and carried labels begin another energy
};

/** \brief How a registration went. */
struct Report {
  StopReason stop_reason{StopReason::NotRun};
  std::string message; ///< for a person; empty when all went well
  /** \brief The optimization ran to its end and found the reference in the other
   * frames: stop_reason is Converged or, as PCL's ICP counts, IterationLimit. What
   * hasConverged () and the tools' exit status say is this. */
  bool converged{false};
  int iterations{0}; ///< over all levels
  /** \brief The light differs between frames by more than exposure: local contrasts of
   * brightness are compared in place of brightness. */
  bool light_changed{false};
  EnergyCost initial_cost; ///< where the last solve at the finest level began
  EnergyCost final_cost;   ///< where it ended
  double frame_seconds{0.0};
  double segment_seconds{0.0};
  double start_seconds{0.0}; ///< optical flow and proposals
  double solve_seconds{0.0};
  double result_seconds{0.0};
  std::vector<IterationRecord> history;
};

/** \brief The result: where every point of the reference has gone, Eq. 1.
 *
 * All images have the reference's size and belong to its pixels. Unknown is NaN, never
 * zero.
 *
 * Confidence. The covariance of a pose is C = D inv (A) + sum p d d' + w S + f inv
 * (A_k) with A the information of its body's residuals; D the factor by which residuals
 * that err alike over large parts of the body count too much, measured from their sums
 * over tiles (1 = independent); d the ways to the motions of neighbours and of the
 * largest body, and p the probabilities, by what the segment's own residuals say, that
 * it moves with them; w S for a segment that is partly not found where it should be,
 * with S the spread of those motions; A_k the segment's own information, f small unless
 * its residuals ask for another motion. A deviation of a point is the root of the mean
 * squared length of its error: the trace of J C J', plus the point's own depth noise,
 * plus the variance that comes from being measured at the wrong side of a depth step a
 * few pixels away, likely where a point is not found at the frame's surface. On
 * generated scenes they are half to twice the errors in the mean; they are made to sort
 * points, and to be of use as weights. Errors that a whole body shares without leaving
 * residuals, as a wrong camera's, are not in them.
 */
struct PCL_MSF_EXPORT SceneFlow {
  PinholeCamera camera; ///< of the reference
  cv::Mat labels;       ///< CV_32SC1, segment of each pixel, -1 = none
  cv::Mat points;       ///< CV_32FC3, reference points, metres; NaN = no depth
  cv::Mat displacement; ///< CV_32FC3, metres; NaN = unknown. A point's own: it may
                        ///< differ from its segment's motion, see SolverParameters'
                        ///< blend_motions and refine_flow
  cv::Mat flow;         ///< CV_32FC2, pixels (u, v); NaN = unknown
  cv::Mat visibility;   ///< CV_8UC1, see Visibility

  /** \brief CV_32FC1, pixels: standard deviation of the flow's error, both directions
   * together, > 0; NaN where the flow is unknown, everywhere without a camera's grid.
   */
  cv::Mat flow_deviation;
  /** \brief CV_32FC1, metres: the same of the displacement, all three together; NaN
   * everywhere, too, where nearest neighbours took the camera's place. */
  cv::Mat displacement_deviation;

  std::vector<SegmentMotion> segments;
  std::vector<GroupMotion> group_motions; ///< element g: segments with group = g
  std::vector<SegmentPair> pairs;         ///< first < second
  union {
    int groups{0}; ///< number of motion groups
    [[deprecated ("use groups")]] int bodies;
  };
  union {
    int dominant_group{-1}; ///< the motion group with most visible points
    [[deprecated ("use dominant_group")]] int dominant_body;
  };
  RigidPose
      dominant_motion; ///< pose of its largest rigid body; its inverse is the camera's
                       ///< own motion when that group is the static scene
  Report report;

  /** \brief Moves a point by a segment's motion. NaN when the label is none or the
   * motion undetermined. \param point reference frame, metres */
  Eigen::Vector3d
  warp (const Eigen::Vector3d& point, int label) const;
};

} // namespace pcl_msf
