// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/point_window.h"

#include <Eigen/Eigenvalues>

#include "core/points/carried_pair.h"
#include "core/points/point_problem.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace pcl_msf {

namespace {

using Pulls = std::vector<std::vector<PointPull>>;

/** The terms of all pairs, chained. */
class Window {
public:
  Window (std::vector<PointFrame>& frames,
          double weight,
          const PointTuning& tuning,
          int threads)
  : frames_ (frames), tuning_ (tuning.window)
  {
    const PointSolve& first = *frames[0].solve;
    PointEnergyWeights weights;
    weights.regularizer = tuning.stages.back().regularizer;
    weights.unit = first.segments().radius;
    for (PointFrame& frame : frames) {
      PointSolve& solve = *frame.solve;
      terms_.push_back (std::make_unique<PointTerms> (solve.samples(),
                                                      solve.known(),
                                                      solve.segments(),
                                                      weights,
                                                      threads,
                                                      solve.poses()));
      problem_.add (*terms_.back());
    }
    weights.regularizer = tuning_.regularizer;
    const std::vector<BodyShape> shapes =
        segmentShapes (first.samples(), first.sampleLabels(), first.segments());
    for (std::size_t f = 0; f < frames.size(); ++f) {
      const int before = frames[f].before;
      carried_.push_back (nullptr);
      if (before < 0)
        continue;
      carried_.back() = std::make_unique<CarriedPair> (
          frames[before], frames[f], weights, tuning_.near, threads);
      PointTerms& between = carried_.back()->terms();
      problem_.add (between);
      problem_.addChain (*terms_[f], *terms_[before], between, shapes, weight);
    }
  }

  /** \return the energy after it */
  double
  step (double distance, int iterations)
  {
    Pulls pulls;
    Pulls carried (frames_.size());
    for (std::size_t f = 0; f < frames_.size(); ++f) {
      pulls.push_back (frames_[f].solve->finePulls (distance));
      if (carried_[f])
        carried[f] = carried_[f]->pulls (frames_[f].solve->rulesOf (distance));
    }
    for (std::size_t f = 0; f < frames_.size(); ++f) {
      terms_[f]->take (pulls[f]);
      if (carried_[f])
        carried_[f]->terms().take (carried[f]);
    }
    return problem_.step (iterations);
  }

private:
  std::vector<PointFrame>& frames_;
  const PointWindowTuning& tuning_;
  std::vector<std::unique_ptr<PointTerms>> terms_; ///< per frame
  std::vector<std::unique_ptr<CarriedPair>>
      carried_; ///< per frame, from the one before
  PointProblem problem_;
};

} // namespace

std::vector<BodyShape>
segmentShapes (const PointSamples& samples,
               const std::vector<int>& label,
               const SurfaceSegments& segments)
{
  std::vector<BodyShape> shapes (segments.size());
  std::vector<Eigen::Matrix3d> moment (segments.size(), Eigen::Matrix3d::Zero());
  std::vector<int> count (segments.size(), 0);
  for (int i = 0; i < samples.size(); ++i) {
    shapes[label[i]].center += samples.points[i].cast<double>();
    ++count[label[i]];
  }
  for (int k = 0; k < segments.size(); ++k)
    shapes[k].center =
        count[k] > 0 ? (shapes[k].center / count[k]).eval() : segments.centroids[k];
  for (int i = 0; i < samples.size(); ++i) {
    const Eigen::Vector3d d =
        samples.points[i].cast<double>() - shapes[label[i]].center;
    moment[label[i]] += d * d.transpose() / count[label[i]];
  }
  for (int k = 0; k < segments.size(); ++k) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen (moment[k]);
    shapes[k].spread = eigen.eigenvectors() *
                       eigen.eigenvalues().cwiseMax (0.0).cwiseSqrt().asDiagonal();
  }
  return shapes;
}

void
solveJointly (std::vector<PointFrame>& frames,
              double weight,
              const PointTuning& tuning,
              int threads,
              SolveProgress& progress)
{
  if (frames.size() < 2 || !(weight > 0.0) || progress.stopped())
    return;
  const PointWindowTuning& values = tuning.window;
  Window window (frames, weight, tuning, threads);
  for (int i = 0; i < values.steps && !progress.stopped(); ++i) {
    const double f = i / std::max (1.0, values.steps - 1.0);
    const double distance = values.from * std::pow (values.to / values.from, f);
    progress.note (0, window.step (distance, tuning.match.iterations), "window");
  }
}

} // namespace pcl_msf
