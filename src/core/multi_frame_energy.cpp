// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/multi_frame_energy.h"

#include "core/body_shapes.h"
#include "core/multi_frame_problem.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

/** The links as they lie in a frame that the poses lead to. */
std::vector<SegmentLink>
carryLinks (const MultiFrameScene& scene, const MotionState& motion)
{
  std::vector<SegmentLink> links = scene.links;
  for (SegmentLink& link : links) {
    const Eigen::Vector3d a = motion.poseOf (link.first) * scene.centroids[link.first];
    const Eigen::Vector3d b =
        motion.poseOf (link.second) * scene.centroids[link.second];
    link.midpoint = 0.5 * (a + b);
  }
  return links;
}

} // namespace

MultiFrameEnergy::MultiFrameEnergy (MultiFrameLevel& level,
                                    const MultiFrameScene& scene,
                                    const EnergyParameters& energy,
                                    double concatenation_weight,
                                    const MultiFrameState& state)
: level_ (level)
, scene_ (scene)
, energy_ (energy)
, concatenation_weight_ (concatenation_weight)
, links_ (scene.frames.size())
, shapes_ (scene.frames.size())
{
  for (int f = 0; f < scene.pairs.frames(); ++f)
    links_[f] = f == scene.pairs.reference()
                    ? scene.links
                    : carryLinks (scene, state.ofPair (scene.pairs.fromReference (f)));
  segments_of_body_.assign (state.bodies(), 0);
  for (const int b : state.body_of)
    ++segments_of_body_[b];
  carryShapes (state);
}

double
MultiFrameEnergy::unit (double depth) const
{
  return level_.focalLength() / std::max (depth, 1e-3);
}

/** eta, once for every pair that pulls at the weight: so the width of the kernel, the
 * difference of poses that lets go, is that of two frames whatever the window. */
double
MultiFrameEnergy::priorWeight() const
{
  return energy_.prior_weight * static_cast<double> (scene_.used.size());
}

CouplingScale
MultiFrameEnergy::couplingScale (const SegmentLink& link, bool with_prior) const
{
  const double share = 1.0 / std::max<std::size_t> (1, scene_.links.size());
  return {std::sqrt (share * energy_.regularizer_weight),
          with_prior ? std::sqrt (share * priorWeight()) : 0.0,
          unit (link.midpoint.z())};
}

double
MultiFrameEnergy::concatenationScale (int segments, double depth) const
{
  return std::sqrt (concatenation_weight_ * segments / scene_.segments) * unit (depth);
}

void
MultiFrameEnergy::carryShapes (const MultiFrameState& state)
{
  const int reference = scene_.pairs.reference();
  shapes_[reference] =
      bodyShapes (level_.pixels (reference), state.body_of, state.bodies());
  for (int f = 0; f < scene_.pairs.frames(); ++f) {
    if (f == reference)
      continue;
    shapes_[f] = shapes_[reference];
    const auto& poses = state.poses[scene_.pairs.fromReference (f)];
    for (std::size_t b = 0; b < poses.size(); ++b) {
      shapes_[f][b].center = poses[b] * shapes_[f][b].center;
      shapes_[f][b].spread = poses[b].rotation() * shapes_[f][b].spread;
    }
  }
}

double
MultiFrameEnergy::squaredDifferences (int link, const MultiFrameState& state) const
{
  double sum = 0.0;
  const int j = state.body_of[scene_.links[link].first];
  const int h = state.body_of[scene_.links[link].second];
  if (j == h)
    return 0.0;
  for (const int p : scene_.used) {
    const SegmentLink& carried = links_[scene_.pairs[p].from][link];
    sum += poseDifference (state.poses[p][j],
                           state.poses[p][h],
                           carried,
                           unit (carried.midpoint.z()),
                           energy_.pose_difference)
               .squaredNorm();
  }
  return sum;
}

void
MultiFrameEnergy::relaxWeights (MultiFrameState& state) const
{
  for (std::size_t i = 0; i < scene_.links.size(); ++i)
    state.weights[i] = optimalWeight (squaredDifferences (static_cast<int> (i), state),
                                      energy_.regularizer_weight,
                                      priorWeight());
}

double
MultiFrameEnergy::concatenationCost (const MultiFrameState& state) const
{
  double sum = 0.0;
  const auto add = [&] (std::unique_ptr<ConcatenationCost> cost,
                        int body,
                        int pair,
                        const std::vector<FramePairs::Step>& steps) {
    std::vector<const double*> blocks{state.poses[pair][body].parameters.data()};
    for (const FramePairs::Step& step : steps)
      blocks.push_back (state.poses[step.pair][body].parameters.data());
    Eigen::Matrix<double, 12, 1> residuals;
    cost->Evaluate (blocks.data(), residuals.data(), nullptr);
    sum += 0.5 * residuals.squaredNorm();
  };
  forEachConcatenation (state, add);
  return sum;
}

EnergyCost
MultiFrameEnergy::evaluate (const MultiFrameState& state)
{
  level_.sweep (state, DataTerm::Pass::Linearize);
  return presentCost (state);
}

EnergyCost
MultiFrameEnergy::presentCost (const MultiFrameState& state) const
{
  EnergyCost cost;
  for (const int p : scene_.used)
    for (int k = 0; k < scene_.segments; ++k) {
      cost.brightness += level_.data (p).of (k).brightness_cost;
      cost.icp += level_.data (p).of (k).icp_cost;
    }
  const double share = 0.5 / std::max<std::size_t> (1, scene_.links.size());
  for (std::size_t i = 0; i < scene_.links.size(); ++i) {
    const double s = state.weights[i] * state.weights[i];
    cost.regularizer += share * energy_.regularizer_weight * s * s *
                        squaredDifferences (static_cast<int> (i), state);
    cost.prior += share * priorWeight() * (1.0 - s) * (1.0 - s);
  }
  cost.concatenation = concatenationCost (state);
  return cost;
}

ResidualCounts
MultiFrameEnergy::countResiduals() const
{
  ResidualCounts counts;
  const int links = static_cast<int> (scene_.links.size());
  for (const int p : scene_.used) {
    const SegmentPixels& pixels = level_.data (p).pixels();
    counts.brightness += pixels.brightness_count;
    counts.icp += pixels.icp_count;
    counts.regularizer += links;
    counts.concatenation += scene_.pairs[p].adjacent ? 0 : scene_.segments;
  }
  counts.prior = links;
  return counts;
}

SolveOutcome
MultiFrameEnergy::minimize (const SolverParameters& solver,
                            SolveMonitor& monitor,
                            MultiFrameState& state)
{
  return minimizeEnergy<MultiFrameProblem> (*this, state, solver, monitor);
}

} // namespace pcl_msf
