// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>

#include <functional>
#include <string>

namespace pcl_msf {

/** \brief Where the reference's normals come from. */
enum class NormalMethod {
  CentralDifferences, ///< Eq. 9: cross product of central differences
  IntegralImage,      ///< pcl::IntegralImageNormalEstimation
  Skip                ///< not computed: enough for a frame that is only a target
};

/** \brief How a frame is prepared. */
struct PCL_MSF_EXPORT FrameParameters {
  double smoothing_sigma{0.7}; ///< Gaussian on the intensity, pixels, [0, 10]; 0 = none
  double min_depth{0.0};       ///< metres; nearer points are dropped, [0, 1e12]
  double max_depth{1000.0};    ///< metres; farther points are dropped, above min_depth,
                               ///< at most 1e12
  int max_levels{5};           ///< pyramid levels at the most, [1, 10]
  int finest_level{0}; ///< [0, 4]: the images are halved so often before anything else,
                       ///< and what is found is carried back to all pixels by their own
                       ///< depth. 1 takes a third of the time, and what is small moves
                       ///< with what is around it
  NormalMethod normals{NormalMethod::CentralDifferences};

  bool
  isValid (std::string* why = nullptr) const;
};

/** \brief How the reference frame is cut into segments. */
enum class SegmentationMethod {
  TangentPlane, ///< clusters on common planes, in units of the sensor's depth noise
  Felzenszwalb, ///< the paper's: graph-based on raw depth (cv::ximgproc)
  Slic,         ///< SLIC superpixels on intensity and depth (cv::ximgproc)
  Tiles,        ///< regular tiles
  Single        ///< one segment: a rigid scene
};

struct PCL_MSF_EXPORT SegmentationParameters {
  SegmentationMethod method{SegmentationMethod::TangentPlane};
  double threshold{0.5};     ///< Felzenszwalb's, the paper's, [1e-9, 1e12]; the
                             ///< smoothing's sigma is 0.5
  int min_points{2000};      ///< Felzenszwalb: smaller segments are merged or discarded
  bool discard_small{false}; ///< Felzenszwalb: discard small segments (true) or merge
  int segment_size{24}; ///< TangentPlane, Slic, Tiles: aimed side, pixels, [4, 512]

  bool
  isValid (std::string* why = nullptr) const;
};

/** \brief The norm on the data terms (Eq. 7 and section 4.1). */
enum class LossType { Huber, L1, L2 };

/** \brief What "two segments move differently" is measured by in Eq. 10. */
enum class PoseDifference {
  Metric, ///< displacement of the point between the segments, and rotation, as pixels
  Parameters ///< the paper's: difference of the six pose parameters
};

/** \brief Weights of Eq. 5. Every term is divided by its number of residuals. */
struct PCL_MSF_EXPORT EnergyParameters {
  double brightness_weight{1.0};  ///< alpha, [0, 1e12]
  double icp_weight{1.0};         ///< beta, [0, 1e12]; alpha and beta are not both 0
  double regularizer_weight{0.1}; ///< gamma, [0, 1e12]; links along a surface count
                                  ///< more
  double prior_weight{0.1};       ///< eta, [1e-12, 1e12]; sqrt (eta / gamma) = width,
                                  ///< pixels
  double huber_threshold{1.0};    ///< epsilon, in standard deviations, [0, 1e12]; 0 =
                                  ///< L1
  LossType loss{LossType::Huber};
  PoseDifference pose_difference{PoseDifference::Metric};
  int neighbors{6}; ///< n_psi, nearest centroids per segment, [0, 64]

  bool
  isValid (std::string* why = nullptr) const;
};

enum class LinearSolver {
  Cgnr,          ///< conjugate gradients on the normal equations, Jacobi
  SparseCholesky ///< sparse Cholesky factorization
};

/** \brief What a progress callback is told. */
struct Progress {
  int level{0};          ///< pyramid level, 0 = finest
  int iteration{0};      ///< iterations so far, over all levels
  double fraction{0.0};  ///< estimated share of the work that is done, [0, 1]
  double cost{0.0};      ///< present energy
  const char* stage{""}; ///< name of the stage; "result" when all is done
};

struct PCL_MSF_EXPORT SolverParameters {
  int max_iterations{
      6}; ///< Levenberg-Marquardt steps per level, fewer on fine ones, >= 0
  double function_tolerance{
      5e-3}; ///< stop when a step lowers E by less than this share, [0, 1]
  double parameter_tolerance{1e-7}; ///< stop when |dx| < tolerance |x|, [0, 1]
  double max_seconds{0.0}; ///< when a registration has taken so long, [0, 1e12], it
                           ///< makes no further step, and the best so far has
                           ///< StopReason::TimeLimit; 0 = no limit. Only steps end
                           ///< so: frames and segments, the start, and in the end the
                           ///< result take their time
  LinearSolver linear_solver{LinearSolver::Cgnr};
  int levels{4};             ///< pyramid levels to use at the most, [1, 10]
  bool flow_proposals{true}; ///< start from optical flow lifted by depth as well
  bool blend_motions{true};  ///< move points by their neighbours' motions, too
  bool refine_flow{true};    ///< adapt the flow to the images, point by point, where
                          ///< points move otherwise than most; poses stay as they are
  bool merge_bodies{true}; ///< merge segments that move as one rigid body
  unsigned threads{0};     ///< [0, 1024], 0 = all; the result does not depend on it

  /** \brief Called after each iteration in the calling thread; false cancels, an
   * exception ends the registration. Unless cancelled, it is called once more when the
   * result is there, with fraction 1; then false changes nothing. */
  std::function<bool (const Progress&)> progress;

  bool
  isValid (std::string* why = nullptr) const;
};

} // namespace pcl_msf
