// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/build_compatibility.h>
#include <pcl_msf/export.h>
#include <pcl_msf/impl/independent_registration.h>
#include <pcl_msf/impl/neighbor_registration.h>
#include <pcl_msf/impl/point_selection.h>
#include <pcl_msf/impl/registration_steps.h>
#include <pcl_msf/lazy_kd_tree.h>
#include <pcl_msf/multiframe_estimator.h>
#include <pcl_msf/registration_settings.h>
#include <pcl_msf/scene_flow.h>

#include <limits>
#include <vector>

namespace pcl_msf {

/** \brief Piecewise-rigid registration of organized RGB-D clouds: one rigid motion per
 * segment of the source to one target (Eq. 5) or to each of several, solved jointly
 * (Eq. 13).
 *
 * \code
 * pcl_msf::PiecewiseRigidRegistration<pcl::PointXYZRGB> registration;
 * registration.setInputSource (reference); // organized, camera's optical frame, metres
 * registration.setInputTarget (current);   // the same size
 * registration.align (warped);             // organized like the source
 * if (registration.hasConverged ())
 *   use (warped, registration.getSceneFlow ());
 * \endcode
 *
 * <b>Input.</b> Points x right, y down, z forward in metres; NaN, inf, or z <= 0 = no
 * measurement. Brightness from rgb, rgba or intensity; types with none of them are
 * aligned by geometry alone; normals in the points are not used, see setSourceNormals.
 * One pinhole camera took both: setCamera, or it is estimated from the source.
 *
 * <b>Output.</b> align's cloud is the source carried to the target, each point by its
 * displacement, organized like the source; normals turn with their segments; other
 * fields, header and sensor pose are the source's. It may be the source itself, not one
 * of the targets. A point without depth or with unknown motion is NaN, never left where
 * it was. The 4x4 matrix is the motion of the dominant motion group (of most visible
 * points); all the rest is in getSceneFlow.
 *
 * <b>Clouds without a grid</b> (scans, merged or filtered clouds, vertices: one row or
 * column, or not width x height points) are registered by nearest neighbours, see
 * setCorrespondence and CloudFlowEstimator: any unit, any z. Brightness that varies
 * over both tells what slides within its surface. Parts are the segments, the same in
 * all frames, getJoints tells how they turn; images of the scene flow are as wide as
 * the cloud, optical flow is NaN. setIndices leaves out points exactly there.
 * setKnownCorrespondences, setCloudConstraints: what is known. Each frame's own report
 * says whether that one was found.
 *
 * <b>Several targets.</b> addInputTarget and setInputTargets make a window of frames in
 * the order of time, the source being the one that setReferenceFrame says, the first by
 * default. align's cloud, the 4x4 matrix, the correspondences and the fitness score
 * then belong to the last target; getSceneFlow (frame), getWarpedCloud (frame) and
 * getPose give all of them. With one target the result is that of two frames, bit for
 * bit. Time grows with the number of pairs of frames.
 *
 * <b>Indices.</b> With setIndices the segments that hold at least one of those points
 * take part, with all of their points, and the output holds those points alone, n x 1
 * (n of all points: organized). To leave out points exactly, use setSegmentation.
 *
 * <b>Clouds refilled in place.</b> align judges all that must fit (indices, labels,
 * clusters, normals, sizes) against the clouds as they are then, and hands the target
 * to the search object anew; lists are copied when set. Results belong to the last
 * align: it keeps a copy of its source.
 *
 * <b>Copies</b> start with the original's settings, clouds and result and share nothing
 * that an align changes. A search object set with force_no_recompute is shared; any
 * other becomes a LazyKdTree of its own with the same settings; a correspondence
 * estimation, which is not used, is not copied. One that was moved from has its
 * settings, but neither clouds nor a result.
 *
 * <b>Convergence.</b> hasConverged () is getReport ().converged. As with PCL's ICP, it
 * is true when the optimization ran to its end: the energy's change fell below the
 * tolerance, or the iteration limit was reached; getReport ().stop_reason tells the two
 * apart. It is false when the time budget or the progress callback cut it short (the
 * output is the best so far), when a target shows a different place (the output is what
 * was found nevertheless), when no motion could be determined (the output is NaN, the
 * matrix the identity), and after a failure. For the last three the reason is printed
 * with PCL_ERROR and in getReport ().message, by nearest neighbours when it was cut
 * short, too; by the camera then only where the best so far fits badly. New targets or
 * an empty source make hasConverged () false, another source does not; getReport () is
 * the last align's.
 *
 * <b>Failure.</b> Bad input prints a PCL_ERROR that names the remedy; then hasConverged
 * () is false, the matrix is the identity, the output is the untransformed source and
 * getReport () repeats the message. Nothing is thrown. An empty or null cloud is not
 * taken, and the former one is dropped, so that no later align works on a stale pair;
 * getInputSource and getInputTarget then give an empty cloud, as they do at first. With
 * indices outside the source the output is empty. An output that is one of the targets
 * is refused and left alone.
 *
 * <b>Behind a base pointer.</b> All of the above holds for a pcl::Registration pointer.
 * Only getFitnessScore differs, see there, getIndices, which gives all points there,
 * and an output that is one of the targets, which PCL has overwritten with the source
 * before it can be refused. Of the inherited settings, these have no effect: RANSAC,
 * correspondence distance, transformation and fitness epsilons, estimators, rejectors,
 * the point representation (except on the search objects). setMaximumIterations bounds
 * the steps per pyramid level, default 6. The visualization callback is called once per
 * successful align, with the warped source and the indices of corresponding points in
 * it and in the target.
 *
 * No kd-tree is built before getSearchMethodTarget or ...Source is queried, see
 * LazyKdTree. An object can be used again; two threads must not use one at once.
 *
 * Instantiated for PointXYZ, PointXYZI, PointXYZRGB, PointXYZRGBA, PointNormal,
 * PointXYZINormal and PointXYZRGBNormal; for other types define PCL_NO_PRECOMPILE
 * before including PCL's headers, as for PCL. Code compiled with -march=native, -mavx2
 * and the like gets instances of its own, see build_compatibility.h.
 */
template <typename PointT>
class PiecewiseRigidRegistration : public detail::IndependentRegistration<PointT>,
                                   public RegistrationSettings {
  using Base = detail::IndependentRegistration<PointT>;

public:
  using Ptr = pcl::shared_ptr<PiecewiseRigidRegistration<PointT>>;
  using ConstPtr = pcl::shared_ptr<const PiecewiseRigidRegistration<PointT>>;
  using typename Base::Matrix4;
  using typename Base::PointCloudSource;
  using typename Base::PointCloudSourceConstPtr;
  using typename Base::PointCloudTargetConstPtr;

  PiecewiseRigidRegistration();

  /** \brief The reference cloud. */
  void
  setInputSource (const PointCloudSourceConstPtr& cloud) override;

  /** \brief The current cloud, the only target. */
  void
  setInputTarget (const PointCloudTargetConstPtr& cloud) override;

  /** \brief One more target, after those given so far. An empty one is refused. */
  void
  addInputTarget (const PointCloudTargetConstPtr& cloud);

  /** \brief All targets, in the order of time. An empty one among them drops all. */
  void
  setInputTargets (const std::vector<PointCloudTargetConstPtr>& clouds);
  /** \brief The same for a vector of other pointers to such clouds. */
  template <typename CloudPtr>
  void
  setInputTargets (const std::vector<CloudPtr>& clouds);

  void
  clearInputTargets ();

  std::vector<PointCloudTargetConstPtr>
  getInputTargets () const
  {
    return targets_;
  }

  /** \brief Place of the source among the frames, 0 (default, before all targets) to
   * the number of targets; judged in align. */
  void
  setReferenceFrame (int frame);
  int
  getReferenceFrame () const
  {
    return reference_;
  }

  /** \brief Points of the source to work on; null = all. Copied, judged in align. */
  void
  setIndices (const pcl::IndicesPtr& indices) override;
  void
  setIndices (const pcl::IndicesConstPtr& indices) override;
  void
  setIndices (const pcl::PointIndicesConstPtr& indices) override;
  /** \brief A rectangle of the source, judged in align; an empty one is refused. */
  void
  setIndices (std::size_t row_start,
              std::size_t col_start,
              std::size_t nb_rows,
              std::size_t nb_cols) override;

  /** \brief A copy of what was set; empty when that is not inside the source. PCL's own
   * when nothing was set: null, after an align all points. */
  pcl::IndicesPtr
  getIndices () const;

  /** \brief Sets `pairs` of CloudConstraints alone, from PCL's: index_query of the
   * source, index_match of the target, of several the first; without a match (index -1)
   * refused. \param weights as KnownPair's, one per pair; empty = 1 each */
  void
  setKnownCorrespondences (const pcl::Correspondences& correspondences,
                           const std::vector<double>& weights = {});
  /** \brief The pairs; their member `weight` is set. */
  pcl::Correspondences
  getKnownCorrespondences () const;

  /** \brief Registers, see above. \note Hide the base's, which run behind a base
   * pointer, with the same result. */
  void
  align (PointCloudSource& output);
  void
  align (PointCloudSource& output, const Matrix4& guess);

  /** \brief Sets `max_iterations` of SolverParameters alone, >= 0, default 6. */
  void
  setMaximumIterations (int iterations);

  /** \brief How Eq. 5 is minimized. Its max_iterations is the inherited one. */
  void
  setSolverParameters (const SolverParameters& parameters);
  SolverParameters
  getSolverParameters () const;

  using Base::getFitnessScore;

  /** \brief Mean squared distance, square metres, between warped points and the
   * target's points at the pixels that they project to, over the points that are
   * visible in both clouds and, as in PCL, whose squared distance is at most max_range.
   * The largest double when there are none. \note Hides the base's. Through a base
   * pointer PCL's own runs: nearest neighbours of the source moved by the dominant
   * motion, which builds the kd-tree; by the camera points without depth do not count,
   * by nearest neighbours all finite ones do. It takes the source as it is then and the
   * target as it was at the first query since align: after clouds were refilled in
   * place, align first. This one keeps what align saw. */
  double
  getFitnessScore (double max_range = (std::numeric_limits<double>::max)());

  /** \brief Pairs of the last align: source index, target index at the pixel that the
   * warped point projects to, squared distance; visible points only. */
  const pcl::Correspondences&
  getCorrespondences () const
  {
    return *this->correspondences_;
  }

  /** \brief Everything that the last align found about the motion to the last target,
   * on the source's pixels. Images are empty after a failure and before the first
   * align. */
  const SceneFlow&
  getSceneFlow () const
  {
    return result_.frames.empty() ? detail::noSceneFlow() : result_.frames[shown_];
  }

  /** \brief The same for another frame of the window, 0 .. number of targets. Empty,
   * with a PCL_ERROR, for frames that there are none of; empty for the source's own. */
  const SceneFlow&
  getSceneFlow (int frame) const;

  /** \brief All frames, and the poses of all pairs of them. */
  const MultiframeSceneFlow&
  getMultiframeSceneFlow () const
  {
    return result_;
  }

  /** \brief The source carried to a frame by the last align, organized like the source,
   * all points. Empty, with a PCL_ERROR, for frames that there are none of. */
  PointCloudSource
  getWarpedCloud (int frame) const;

  /** \brief T_k^{from,to} of a segment: points of frame `from` to frame `to`. Identity,
   * with a PCL_ERROR, for frames or segments that there are none of. */
  Matrix4
  getPose (int from, int to, int segment) const;

  /** \brief Joints between the parts that the last align found by nearest neighbours,
   * as they turn to the last target, by the numbers of the scene flow's groups. */
  const std::vector<CloudJoint>&
  getJoints () const
  {
    return joints_.empty() ? detail::noJoints() : joints_[shown_];
  }

  /** \brief The same for another frame, empty as getSceneFlow (frame). */
  const std::vector<CloudJoint>&
  getJoints (int frame) const;

  /** \brief How the last align went: stop reason, message, times, energy; without a
   * grid that of the first target that was not found, if any. */
  const Report&
  getReport () const
  {
    return result_.frames.empty() ? detail::noSceneFlow().report : result_.report();
  }

protected:
  /** \brief Section 3, from clouds to scene flow. */
  void
  computeTransformation (PointCloudSource& output, const Matrix4& guess) override;

private:
  /** Keeps the source as it is now. \return its points to work on, which alone remain
   * in the output \throws InvalidInput naming the remedy */
  pcl::Indices
  takeSource (PointCloudSource& output);
  void
  checkTargets () const;
  bool
  usesNeighbors () const;
  void
  requireFittingNormals () const;
  void
  requireFittingLabels () const;
  detail::NeighborTask
  neighborTask (const pcl::Indices& points, const Matrix4& guess) const;
  void
  matchNeighbors (const pcl::Indices& points,
                  const Matrix4& guess,
                  PointCloudSource& output);
  bool
  isTarget (const PointCloudSource& cloud) const;
  std::vector<RgbdFrame>
  makeFrames () const;
  Oversegmentation
  cutSegments (const RgbdFrame& reference, const pcl::Indices& points) const;
  void
  minimizeEnergy (const std::vector<RgbdFrame>& frames,
                  const Oversegmentation& segments,
                  const Matrix4& guess,
                  double seconds_gone);
  void
  findCorrespondences (const PointCloudSource& warped, const pcl::Indices& points);
  void
  publish ();
  void
  setFinalTransformation (const Matrix4& transformation);
  void
  fail (StopReason reason, const char* why);
  void
  showResult (const PointCloudSource& warped, const pcl::Indices& points) const;

  std::vector<PointCloudTargetConstPtr> targets_; ///< in the order of time
  PointCloudSourceConstPtr aligned_;              ///< the last align's source, a copy
  int reference_{0};
  MultiframeSceneFlow result_;
  std::vector<std::vector<CloudJoint>> joints_; ///< per frame; empty = by the camera
  int shown_{0};             ///< frame of the last target, in result_
  bool by_neighbors_{false}; ///< was the last source registered so?
  detail::PointSelection selection_;

public:
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

} // namespace pcl_msf

#include <pcl_msf/impl/piecewise_rigid_registration.hpp>
