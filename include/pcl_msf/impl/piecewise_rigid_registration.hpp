// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/type_traits.h>

#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/impl/piecewise_rigid_registration_inputs.hpp>
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
PiecewiseRigidRegistration<PointT>::computeTransformation (PointCloudSource& output,
                                                           const Matrix4& guess)
{
  this->correspondences_->clear();
  this->nr_iterations_ = 0;
  try {
    checkInput();
    aligned_ = this->input_;
    detail::Stopwatch watch;
    const std::vector<RgbdFrame> frames = makeFrames(); // section 3.3
    const double frame_seconds = watch.lap();
    const Oversegmentation segments = cutSegments (frames[reference_]); // section 3.3
    const double segment_seconds = watch.lap();
    minimizeEnergy (frames, segments, guess, frame_seconds + segment_seconds); // Eq. 13
    for (SceneFlow& flow : result_.frames) {
      flow.report.frame_seconds = frame_seconds;
      flow.report.segment_seconds = segment_seconds;
    }
    warp (getSceneFlow(), *this->indices_, output); // Eq. 1
    findCorrespondences (output);
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
  showResult (output);
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::checkInput() const
{
  if (this->input_->empty())
    throw InvalidInput ("there is no source: call setInputSource");
  if (targets_.empty())
    throw InvalidInput ("there is no target: call setInputTarget");
  if (!indices_fit_)
    throw InvalidInput ("an index is outside the source: call setIndices with the "
                        "source's own, or with a null pointer for all points");
  if (this->indices_->empty())
    throw InvalidInput ("the list of indices is empty: call setIndices with some, or "
                        "with a null pointer for all points");
  requireOrganized (*this->input_, "source");
  for (std::size_t k = 0; k < targets_.size(); ++k)
    requireOrganized (*targets_[k], detail::targetName (k, targets_.size()));
  if (reference_ > static_cast<int> (targets_.size()))
    throw InvalidInput ("the reference frame lies beyond the targets: call "
                        "setReferenceFrame with 0 to their number");
}

template <typename PointT>
std::vector<RgbdFrame>
PiecewiseRigidRegistration<PointT>::makeFrames() const
{
  std::vector<detail::CloudImages> clouds;
  for (const PointCloudTargetConstPtr& target : targets_)
    clouds.push_back ({coordinateImage (*target), colorImage (*target)});
  clouds.insert (clouds.begin() + reference_,
                 {coordinateImage (*this->input_), colorImage (*this->input_)});
  return detail::makeFrames (std::move (clouds),
                             reference_,
                             camera_,
                             frame_,
                             normals_ ? normalImage (*normals_) : cv::Mat());
}

template <typename PointT>
Oversegmentation
PiecewiseRigidRegistration<PointT>::cutSegments (const RgbdFrame& reference) const
{
  Oversegmentation segments;
  if (labels_ && (labels_->width != this->input_->width ||
                  labels_->height != this->input_->height))
    throw InvalidInput ("the labels have another size than the source: call "
                        "setSegmentation with its own, or clearSegmentation");
  if (labels_)
    segments = Oversegmentation::fromLabels (labelImage (*labels_), reference);
  else if (!clusters_.empty())
    segments = Oversegmentation::fromIndices (clusters_, reference);
  else {
    SegmentationParameters cut = segmentation_;
    if (rigid_)
      cut.method = SegmentationMethod::Single;
    segments = Oversegmentation::fromFrame (reference, cut);
  }
  if (this->indices_->size() == this->input_->size())
    return segments;
  return detail::segmentsHolding (*this->indices_, segments, reference);
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
    solver.max_seconds = std::max (1e-6, solver.max_seconds - seconds_gone);
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
PiecewiseRigidRegistration<PointT>::warp (const SceneFlow& flow,
                                          const pcl::Indices& indices,
                                          PointCloudSource& output) const
{
  std::vector<Eigen::Matrix3f> rotations;
  for (const SegmentMotion& segment : flow.segments)
    rotations.emplace_back (segment.current_from_reference.rotation().cast<float>());
  const int width = static_cast<int> (flow.labels.cols);
  for (std::size_t i = 0; i < output.size(); ++i) {
    const int index = indices[i];
    const int v = index / width;
    const int u = index % width;
    const auto& d = flow.displacement.template at<cv::Vec3f> (v, u);
    output[i].getVector3fMap() += Eigen::Vector3f (d[0], d[1], d[2]);
    if (!pcl::isXYZFinite (output[i])) {
      output[i].getVector3fMap().setConstant (std::numeric_limits<float>::quiet_NaN());
      output.is_dense = false;
      continue;
    }
    if constexpr (pcl::traits::has_normal<PointT>::value) {
      const int label = flow.labels.template at<int> (v, u);
      auto normal = output[i].getNormalVector3fMap();
      if (label >= 0)
        normal = (rotations[label] * normal).eval();
    }
  }
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::publish()
{
  const SceneFlow& flow = getSceneFlow();
  this->final_transformation_ = flow.dominant_motion.matrix();
  this->transformation_ = this->final_transformation_;
  this->nr_iterations_ = flow.report.iterations;
  // As PCL's ICP: reaching the iteration limit is an ordinary end.
  const StopReason reason = flow.report.stop_reason;
  this->converged_ =
      reason == StopReason::Converged || reason == StopReason::IterationLimit;
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::fail (StopReason reason, const char* why)
{
  printError ("align", why);
  shown_ = 0;
  aligned_.reset();
  result_ = detail::failedFlow (reason, why);
  this->converged_ = false;
}

} // namespace pcl_msf
