// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/impl/piecewise_rigid_registration_inputs.hpp>
#include <pcl_msf/impl/piecewise_rigid_registration_neighbors.hpp>
#include <pcl_msf/impl/piecewise_rigid_registration_results.hpp>
#include <pcl_msf/impl/registration_steps.h>
#include <pcl_msf/piecewise_rigid_registration.h>

#include <algorithm>
#include <cmath>
#include <vector>

/* The work of PiecewiseRigidRegistration: align and its results. */
namespace pcl_msf {

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::align (PointCloudSource& output)
{
  align (output, Matrix4::Identity());
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::align (PointCloudSource& output,
                                           const Matrix4& guess)
{
  if (isTarget (output)) // the base would overwrite it
    fail (StopReason::InvalidInput,
          "the output is one of the targets: give another cloud");
  else
    Base::align (output, guess);
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::computeTransformation (PointCloudSource& output,
                                                           const Matrix4& guess)
{
  this->correspondences_->clear();
  this->nr_iterations_ = 0;
  joints_.clear();
  this->target_cloud_updated_ = true; // by the next align it may have other points
  pcl::Indices points;
  try {
    points = takeSource (output);
    checkTargets();
    if (by_neighbors_) {
      matchNeighbors (points, guess, output);
      showResult (output, points);
      return;
    }
    if (!constraints_.empty())
      throw InvalidInput ("constraints are for nearest neighbours: call "
                          "setCorrespondence (NearestNeighbor), or setCloudConstraints "
                          "({})");
    detail::Stopwatch watch;
    const std::vector<RgbdFrame> frames = makeFrames(); // section 3.3
    const double frame_seconds = watch.lap();
    const Oversegmentation segments =
        cutSegments (frames[reference_], points); // section 3.3
    const double segment_seconds = watch.lap();
    minimizeEnergy (frames, segments, guess, frame_seconds + segment_seconds); // Eq. 13
    for (SceneFlow& flow : result_.frames) {
      flow.report.frame_seconds = frame_seconds;
      flow.report.segment_seconds = segment_seconds;
    }
    detail::warpCloud (getSceneFlow(), points, output); // Eq. 1
    findCorrespondences (output, points);
    publish();
  }
  catch (const InvalidInput& error) {
    return fail (StopReason::InvalidInput, error.what());
  }
  catch (const std::exception& error) {
    return fail (StopReason::NumericalFailure, error.what());
  }
  catch (...) {
    return fail (StopReason::NumericalFailure, "unknown error, from a callback?");
  }
  showResult (output, points);
}

template <typename PointT>
pcl::Indices
PiecewiseRigidRegistration<PointT>::takeSource (PointCloudSource& output)
{
  if (isTarget (output))
    throw InvalidInput ("the output is one of the targets, which have to be set anew: "
                        "give another cloud");
  // A copy, because the output can be the source, which can be filled anew later, too.
  const auto source = pcl::make_shared<PointCloudSource> (*this->input_);
  const std::string no_grid = detail::whyNoGrid (*source, "source"); // as it came
  detail::fitShape (*source);
  aligned_ = source;
  by_neighbors_ = usesNeighbors();
  output.sensor_origin_ = source->sensor_origin_;
  output.sensor_orientation_ = source->sensor_orientation_;
  pcl::Indices points;
  const std::string misfit =
      selection_.find (source->width, source->height, source->size(), points);
  if (!misfit.empty())
    output.clear();
  else if (!selection_.isAll())
    detail::pickPoints (*source, points, output);
  else
    detail::fitShape (output);
  if (source->empty())
    throw InvalidInput ("there is no source, or its cloud has no points: fill it, or "
                        "call setInputSource");
  if (!misfit.empty())
    throw InvalidInput (misfit);
  if (!by_neighbors_ && !no_grid.empty())
    throw InvalidInput (no_grid);
  return points;
}

template <typename PointT>
bool
PiecewiseRigidRegistration<PointT>::isTarget (const PointCloudSource& cloud) const
{
  return std::any_of (targets_.begin(), targets_.end(), [&cloud] (const auto& target) {
    return target.get() == &cloud;
  });
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::checkTargets() const
{
  if (targets_.empty())
    throw InvalidInput ("there is no target: call setInputTarget");
  for (std::size_t k = 0; k < targets_.size(); ++k) {
    const std::string name = detail::targetName (k, targets_.size());
    if (targets_[k]->empty())
      throw InvalidInput ("the " + name +
                          " is empty: fill it, or set the targets anew");
    const std::string no_grid = detail::whyNoGrid (*targets_[k], name);
    if (!by_neighbors_ && !no_grid.empty())
      throw InvalidInput (no_grid);
  }
  if (reference_ > static_cast<int> (targets_.size()))
    throw InvalidInput ("the reference frame lies beyond the targets: call "
                        "setReferenceFrame with 0 to their number");
}

template <typename PointT>
std::vector<RgbdFrame>
PiecewiseRigidRegistration<PointT>::makeFrames() const
{
  requireFittingNormals();
  std::vector<detail::CloudImages> clouds;
  for (const PointCloudTargetConstPtr& target : targets_)
    clouds.push_back ({coordinateImage (*target), colorImage (*target)});
  clouds.insert (clouds.begin() + reference_,
                 {coordinateImage (*aligned_), colorImage (*aligned_)});
  return detail::makeFrames (std::move (clouds),
                             reference_,
                             camera_,
                             frame_,
                             normals_ ? normalImage (*normals_) : cv::Mat());
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::requireFittingNormals() const
{
  if (!normals_)
    return;
  const bool organized = by_neighbors_ || (normals_->width == aligned_->width &&
                                           normals_->height == aligned_->height);
  if (!organized && normals_->size() == aligned_->size())
    throw InvalidInput ("the normals are not organized like the source: call "
                        "setSourceNormals with its own, or with null");
  if (normals_->size() != aligned_->size())
    throw InvalidInput ("there are " + std::to_string (normals_->size()) +
                        " normals for " + std::to_string (aligned_->size()) +
                        " points: call setSourceNormals with the source's own, or with "
                        "null");
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::requireFittingLabels() const
{
  if (!labels_)
    return;
  const bool fits = by_neighbors_ ? labels_->size() == aligned_->size()
                                  : labels_->width == aligned_->width &&
                                        labels_->height == aligned_->height;
  if (!fits)
    throw InvalidInput ("the labels have another size than the source: call "
                        "setSegmentation with its own, or clearSegmentation");
}

template <typename PointT>
Oversegmentation
PiecewiseRigidRegistration<PointT>::cutSegments (const RgbdFrame& reference,
                                                 const pcl::Indices& points) const
{
  Oversegmentation segments;
  requireFittingLabels();
  if (labels_)
    segments = Oversegmentation::fromLabels (labelImage (*labels_), reference);
  else if (!clusters_.empty())
    segments = Oversegmentation::fromIndices (clusters_, reference);
  else
    segments =
        Oversegmentation::fromFrame (reference, segmentation_, getNumberOfThreads());
  if (points.size() == aligned_->size())
    return segments;
  return detail::segmentsHolding (points, segments, reference);
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::minimizeEnergy (
    const std::vector<RgbdFrame>& frames,
    const Oversegmentation& segments,
    const Matrix4& guess,
    double seconds_gone)
{
  SolverParameters solver = getSolverParameters();
  if (solver.max_seconds > 0.0) // what is left of align's budget; 0 would be no limit
    solver.max_seconds = (std::max) (1e-6, solver.max_seconds - seconds_gone);
  detail::GuardedProgress progress (solver.progress);
  solver.progress = progress.function();
  shown_ = detail::lastTarget (static_cast<int> (frames.size()), reference_);
  result_ = MultiframeEstimator (energy_, solver, multiframe_)
                .estimate (frames, reference_, segments, detail::startPose (guess));
  progress.rethrow();
  const std::string why = detail::whyUnusable (getSceneFlow());
  if (!why.empty())
    throw std::runtime_error (why);
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::publish()
{
  const Report& report = getReport();
  setFinalTransformation (getSceneFlow().dominant_motion.matrix());
  this->nr_iterations_ = report.iterations;
  this->converged_ = report.converged;
  if (!this->converged_ && !report.message.empty())
    printError ("align", report.message);
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::setFinalTransformation (
    const Matrix4& transformation)
{
  this->final_transformation_ = this->transformation_ = transformation;
  // By it getFitnessScore of the base moves the source's points to where it searches.
  const auto tree = std::dynamic_pointer_cast<LazyKdTree<PointT>> (this->tree_);
  if (!tree || this->force_no_recompute_)
    return;
  if (by_neighbors_)
    tree->clearQueryCamera();
  else
    tree->setQueryCamera (transformation);
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::fail (StopReason reason, const char* why)
{
  printError ("align", why);
  shown_ = 0;
  aligned_.reset();
  result_ = detail::failedFlow (reason, why);
  this->correspondences_->clear();
  this->nr_iterations_ = 0;
  setFinalTransformation (Matrix4::Identity());
  this->converged_ = false;
}

} // namespace pcl_msf

#if !defined(PCL_NO_PRECOMPILE) && PCL_MSF_SAME_LAYOUT
namespace pcl_msf {
extern template class PCL_MSF_EXPORT PiecewiseRigidRegistration<pcl::PointXYZ>;
extern template class PCL_MSF_EXPORT PiecewiseRigidRegistration<pcl::PointXYZI>;
extern template class PCL_MSF_EXPORT PiecewiseRigidRegistration<pcl::PointXYZRGB>;
extern template class PCL_MSF_EXPORT PiecewiseRigidRegistration<pcl::PointXYZRGBA>;
extern template class PCL_MSF_EXPORT PiecewiseRigidRegistration<pcl::PointNormal>;
extern template class PCL_MSF_EXPORT PiecewiseRigidRegistration<pcl::PointXYZINormal>;
extern template class PCL_MSF_EXPORT PiecewiseRigidRegistration<pcl::PointXYZRGBNormal>;
} // namespace pcl_msf
#endif
