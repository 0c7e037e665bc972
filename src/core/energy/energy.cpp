// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/energy/energy.h"

#include "core/energy/body_shapes.h"
#include "core/energy/eliminated_coupling.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <type_traits>

namespace pcl_msf {

namespace {

/** The links as they lie in a frame that the poses lead to. */
std::vector<SegmentLink>
carryLinks (const WindowScene& scene, const MotionState& motion)
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

Energy::Energy (WindowLevel& level,
                const WindowScene& scene,
                const EnergyParameters& parameters,
                double concatenation_weight,
                const WindowState& state)
: level_ (level)
, scene_ (scene)
, parameters_ (parameters)
, concatenation_weight_ (concatenation_weight)
, links_ (scene.frames.size())
, segments_of_body_ (state.bodies())
{
  bool adjacent = true;
  for (const int p : scene.used) {
    const int from = scene.pairs[p].from;
    adjacent &= scene.pairs[p].adjacent;
    if (links_[from].empty())
      links_[from] =
          from == scene.pairs.reference()
              ? scene.links
              : carryLinks (scene, state.ofPair (scene.pairs.fromReference (from)));
  }
  for (int k = 0; k < scene.segments; ++k)
    segments_of_body_[state.body_of[k]].push_back (k);
  if (!adjacent)
    carryShapes (state);
}

double
Energy::unit (double depth) const
{
  return level_.focalLength() / std::max (depth, 1e-3);
}

/** eta, once for every pair that shares the weight: so the width of the kernel is that
 * of two frames whatever the window. */
double
Energy::priorWeight() const
{
  return parameters_.prior_weight * static_cast<double> (scene_.used.size());
}

void
Energy::carryShapes (const WindowState& state)
{
  const int reference = scene_.pairs.reference();
  shapes_.assign (
      scene_.frames.size(),
      bodyShapes (level_.pixels (reference), state.body_of, state.bodies()));
  for (int f = 0; f < scene_.pairs.frames(); ++f) {
    if (f == reference)
      continue;
    const auto& poses = state.poses[scene_.pairs.fromReference (f)];
    for (std::size_t b = 0; b < poses.size(); ++b) {
      shapes_[f][b].center = poses[b] * shapes_[f][b].center;
      shapes_[f][b].spread = poses[b].rotation() * shapes_[f][b].spread;
    }
  }
}

/** Per link, |d|^2 of Eq. 10 summed over the pairs. */
std::vector<double>
Energy::squaredDifferences (const WindowState& state) const
{
  std::vector<double> sums (scene_.links.size(), 0.0);
  for (const int p : scene_.used) {
    const std::vector<UnpackedPose> poses (state.poses[p].begin(),
                                           state.poses[p].end());
    const std::vector<SegmentLink>& links = links_[scene_.pairs[p].from];
    for (std::size_t i = 0; i < links.size(); ++i) {
      const int j = state.body_of[links[i].first];
      const int h = state.body_of[links[i].second];
      if (j != h)
        sums[i] += poseDifference (poses[j],
                                   poses[h],
                                   links[i],
                                   unit (links[i].midpoint.z()),
                                   parameters_.pose_difference)
                       .squaredNorm();
    }
  }
  return sums;
}

void
Energy::relaxWeights (WindowState& state) const
{
  const std::vector<double> differences = squaredDifferences (state);
  for (std::size_t i = 0; i < differences.size(); ++i)
    state.weights[i] = weightAt (differences[i]);
}

double
Energy::weightAt (double squared_difference) const
{
  return optimalWeight (
      squared_difference, parameters_.regularizer_weight, priorWeight());
}

template <typename State, typename Visitor>
void
Energy::forEachConcatenation (State& state, const Visitor& visit) const
{
  using Block = std::conditional_t<std::is_const_v<State>, const double*, double*>;
  for (const int p : scene_.used) {
    if (scene_.pairs[p].adjacent)
      continue;
    const std::vector<FramePairs::Step> steps = scene_.pairs.chain (p);
    std::vector<bool> inverse;
    for (const FramePairs::Step& step : steps)
      inverse.push_back (step.inverse);
    const std::vector<BodyShape>& shapes = shapes_[scene_.pairs[p].from];
    for (int b = 0; b < state.bodies(); ++b) {
      std::vector<Block> blocks{state.poses[p][b].parameters.data()};
      for (const FramePairs::Step& step : steps)
        blocks.push_back (state.poses[step.pair][b].parameters.data());
      const double weight = concatenation_weight_ *
                            static_cast<double> (segments_of_body_[b].size()) /
                            scene_.segments;
      visit (b,
             std::make_unique<ConcatenationCost> (
                 shapes[b], inverse, std::sqrt (weight) * unit (shapes[b].center.z())),
             blocks);
    }
  }
}

/** Per body. */
std::vector<double>
Energy::concatenationCosts (const WindowState& state) const
{
  std::vector<double> sums (state.bodies(), 0.0);
  if (concatenation_weight_ > 0.0)
    forEachConcatenation (state,
                          [&] (int body,
                               const std::unique_ptr<ConcatenationCost>& cost,
                               const std::vector<const double*>& blocks) {
                            Eigen::Matrix<double, 12, 1> residuals;
                            cost->Evaluate (blocks.data(), residuals.data(), nullptr);
                            sums[body] += 0.5 * residuals.squaredNorm();
                          });
  return sums;
}

BodyCosts
Energy::bodyCosts (const WindowState& state) const
{
  BodyCosts costs{concatenationCosts (state), 0.0};
  for (const int p : scene_.used)
    for (int k = 0; k < scene_.segments; ++k)
      costs.of[state.body_of[k]] += level_.data (p).of (k).cost();
  costs.total = std::accumulate (costs.of.begin(), costs.of.end(), 0.0);
  const std::vector<double> differences = squaredDifferences (state);
  const double share = 0.5 / std::max<std::size_t> (1, differences.size());
  for (std::size_t i = 0; i < differences.size(); ++i) {
    const double m = parameters_.regularizer_weight * differences[i];
    const double eta = priorWeight();
    const double cost =
        share * scene_.links[i].strength * m * eta / std::max (m + eta, 1e-300);
    costs.of[state.body_of[scene_.links[i].first]] += cost;
    costs.of[state.body_of[scene_.links[i].second]] += cost;
    costs.total += cost;
  }
  return costs;
}

EnergyCost
Energy::evaluate (const WindowState& state)
{
  level_.sweep (state, DataTerm::Pass::Linearize);
  return presentCost (state);
}

EnergyCost
Energy::presentCost (const WindowState& state) const
{
  EnergyCost cost;
  for (const int p : scene_.used)
    for (int k = 0; k < scene_.segments; ++k) {
      cost.brightness += level_.data (p).of (k).brightness_cost;
      cost.icp += level_.data (p).of (k).icp_cost;
      cost.flow += level_.data (p).of (k).flow_cost;
    }
  const std::vector<double> differences = squaredDifferences (state);
  const double share = 0.5 / std::max<std::size_t> (1, differences.size());
  for (std::size_t i = 0; i < differences.size(); ++i) {
    const double w = eliminatesWeights() ? weightAt (differences[i]) : state.weights[i];
    const double s = w * w;
    const double worth = share * scene_.links[i].strength;
    cost.regularizer += worth * parameters_.regularizer_weight * s * s * differences[i];
    cost.prior += worth * priorWeight() * (1.0 - s) * (1.0 - s);
  }
  const std::vector<double> concatenations = concatenationCosts (state);
  cost.concatenation =
      std::accumulate (concatenations.begin(), concatenations.end(), 0.0);
  return cost;
}

void
Energy::addCouplings (ceres::Problem& problem,
                      WindowState& state,
                      const CoupledPoses& poses) const
{
  const double share = 1.0 / std::max<std::size_t> (1, scene_.links.size());
  for (std::size_t i = 0; i < scene_.links.size(); ++i) {
    const int j = state.body_of[scene_.links[i].first];
    const int h = state.body_of[scene_.links[i].second];
    if (j == h || !(moves (j) || moves (h)))
      continue;
    const double worth = share * scene_.links[i].strength;
    for (const int p : scene_.used) {
      const SegmentLink& link = links_[scene_.pairs[p].from][i];
      const double prior = p == scene_.used.front() ? priorWeight() : 0.0;
      const CouplingScale scale{std::sqrt (worth * parameters_.regularizer_weight),
                                std::sqrt (worth * prior),
                                unit (link.midpoint.z())};
      if (eliminatesWeights()) {
        problem.AddResidualBlock (
            new EliminatedCouplingCost (
                link, scale, parameters_.pose_difference, &poses[p][j], &poses[p][h]),
            nullptr,
            state.poses[p][j].parameters.data(),
            state.poses[p][h].parameters.data());
      }
      else
        problem.AddResidualBlock (
            new PoseCouplingCost (
                link, scale, parameters_.pose_difference, &poses[p][j], &poses[p][h]),
            nullptr,
            state.poses[p][j].parameters.data(),
            state.poses[p][h].parameters.data(),
            &state.weights[i]);
      for (const int body : {j, h})
        if (!moves (body))
          problem.SetParameterBlockConstant (state.poses[p][body].parameters.data());
    }
  }
}

void
Energy::addTo (ceres::Problem& problem,
               WindowState& state,
               const CoupledPoses& poses) const
{
  if (parameters_.regularizer_weight > 0.0)
    addCouplings (problem, state, poses);
  if (concatenation_weight_ > 0.0)
    forEachConcatenation (
        state,
        [&] (int body, std::unique_ptr<ConcatenationCost> cost, const auto& blocks) {
          if (moves (body))
            problem.AddResidualBlock (cost.release(), nullptr, blocks);
        });
}

ResidualCounts
Energy::countResiduals() const
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

} // namespace pcl_msf
