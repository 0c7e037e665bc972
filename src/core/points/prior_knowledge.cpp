// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/prior_knowledge.h"

#include <Eigen/Eigenvalues>

#include "core/points/segment_start.h"
#include "core/surface/point_tree.h"
#include <pcl_msf/errors.h>

#include <limits>
#include <string>

namespace pcl_msf {

namespace {

constexpr double kOffLine = 1e-3; // of squared lengths across and along

void
requireIndex (int index, std::size_t size, const char* cloud)
{
  if (index < 0 || static_cast<std::size_t> (index) >= size)
    throw InvalidInput ("a known pair has index " + std::to_string (index) + ", the " +
                        cloud + " only " + std::to_string (size) +
                        " points: give indices of the two clouds");
}

/** Where a point of the source moves with: near it, on the same side of the surface,
 * in its own segment if segments are given. */
class Places {
public:
  Places (const WorkingCloud& cloud, float one_side)
  : cloud_ (cloud), one_side_ (one_side), tree_ (cloud.surface.points)
  {}

  void
  find (int segment, KnownPoint& known) const
  {
    const Surface& surface = cloud_.surface;
    known.place = tree_.nearest (known.point).index;
    if (segment >= 0 && cloud_.segment[known.place] != segment)
      known.place = nearestOf (segment, known.point);
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t s = 0; s < cloud_.samples.size(); ++s) {
      const int i = cloud_.samples[s];
      const bool apart =
          segment >= 0
              ? cloud_.segment[i] != segment
              : surface.normals[i].dot (surface.normals[known.place]) < one_side_;
      const float d =
          (surface.points[i] - known.point).squaredNorm() + (apart ? kFar : 0.0f);
      if (d < least) {
        least = d;
        known.sample = static_cast<int> (s);
      }
    }
  }

private:
  static constexpr float kFar = 10.0f; // squared sizes: farther than any point is

  int
  nearestOf (int segment, const Eigen::Vector3f& point) const
  {
    int best = 0;
    float least = std::numeric_limits<float>::infinity();
    for (int i = 0; i < cloud_.surface.size(); ++i) {
      const float d = (cloud_.surface.points[i] - point).squaredNorm();
      if (cloud_.segment[i] == segment && d < least) {
        least = d;
        best = i;
      }
    }
    return best;
  }

  const WorkingCloud& cloud_;
  const float one_side_; ///< cosine between normals of one side
  PointTree tree_;
};

/** The working segment with a label. */
int
requireSegment (int label, const PointClouds& clouds, const GivenSegments& segments)
{
  const int given = segments.find (label);
  const WorkingCloud& cloud = clouds.source;
  for (std::size_t i = 0; i < cloud.segment.size(); ++i)
    if (segments.of[cloud.given[i]] == given)
      return cloud.segment[i];
  throw InvalidInput ("the constraints name segment " + std::to_string (label) +
                      ", in which the source has no point on a surface: give segments, "
                      "and labels of them");
}

void
addSegments (const CloudConstraints& constraints,
             const PointClouds& clouds,
             const GivenSegments& segments,
             PriorKnowledge& prior)
{
  for (const int label : constraints.fixed_segments) {
    const int segment = requireSegment (label, clouds, segments);
    prior.fixed.resize (segments.labels.size(), 0);
    prior.fixed[segment] = 1;
  }
  for (const SegmentGuess& guess : constraints.guesses)
    prior.guesses.emplace_back (requireSegment (guess.segment, clouds, segments),
                                clouds.scaled (guess.target_from_source));
}

} // namespace

PointPull
KnownPoint::pull (double unit) const
{
  PointPull pull;
  pull.add (target, Eigen::Vector3d::Zero(), unit * weight, 1.0);
  return pull;
}

void
PriorKnowledge::weigh (const std::vector<int>& chosen,
                       std::vector<PointPull>& pulls) const
{
  if (weights.empty())
    return;
  for (std::size_t i = 0; i < pulls.size(); ++i) {
    const double w = weights[chosen.empty() ? i : chosen[i]];
    pulls[i].a *= w;
    pulls[i].b *= w;
    pulls[i].c *= w;
    pulls[i].weight *= w;
  }
}

PriorKnowledge
priorKnowledge (const CloudConstraints& constraints,
                const PointClouds& clouds,
                const GivenSegments& segments,
                const std::vector<Eigen::Vector3f>& source,
                const std::vector<Eigen::Vector3f>& target,
                const PointMatchTuning& tuning)
{
  PriorKnowledge prior;
  if (constraints.empty())
    return prior;
  const std::vector<float>& weights = constraints.point_weights;
  if (!weights.empty() && weights.size() != source.size())
    throw InvalidInput ("there are " + std::to_string (weights.size()) +
                        " weights for " + std::to_string (source.size()) +
                        " points: give one per point of the source, or none");
  if (!weights.empty())
    for (const int i : clouds.source.given)
      prior.weights.push_back (weights[i]);
  const std::vector<int> working = workingSegments (clouds, segments, source);
  addSegments (constraints, clouds, segments, prior);
  const Places places (clouds.source, tuning.one_side);
  for (const KnownPair& pair : constraints.pairs) {
    requireIndex (pair.source, source.size(), "source");
    requireIndex (pair.target, target.size(), "target");
    const int segment = segments.of.empty() ? -1 : segments.of[pair.source];
    if (!source[pair.source].allFinite() || !target[pair.target].allFinite() ||
        (segment < 0 && !segments.of.empty()))
      continue;
    KnownPoint known;
    known.point = clouds.scaled (source[pair.source]);
    known.target = clouds.scaled (target[pair.target]).cast<double>();
    known.weight = pair.weight;
    places.find (segment < 0 ? -1 : working[segment], known);
    prior.points.push_back (known);
  }
  return prior;
}

RigidPose
commonMotion (const std::vector<KnownPoint>& known,
              const std::vector<Eigen::Vector3f>& at,
              const LimbTuning& tuning)
{
  const auto n = static_cast<Eigen::Index> (known.size());
  Eigen::Matrix3Xd from (3, n);
  Eigen::Matrix3Xd to (3, n);
  std::vector<double> weights;
  for (Eigen::Index i = 0; i < n; ++i) {
    from.col (i) = at[i].cast<double>();
    to.col (i) = known[i].target;
    weights.push_back (known[i].weight);
  }
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < n; ++i) {
    mean += from.col (i) / static_cast<double> (n);
    shift += (to.col (i) - from.col (i)) / static_cast<double> (n);
  }
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector3d d = from.col (i) - mean;
    scatter += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread (scatter);
  if (spread.eigenvalues()[1] > kOffLine * spread.eigenvalues()[2])
    return fitPairs (from, to, weights, tuning.elsewhere, tuning);
  return RigidPose::fromMatrix (Eigen::Matrix3d::Identity(), shift);
}

} // namespace pcl_msf
