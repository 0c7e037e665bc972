// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/result/pose_covariance.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/base/flatten.h"
#include "core/base/parallel_for.h"
#include "core/result/common_errors.h"
#include "core/segments/segment_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_msf {

namespace {

Vector6
parametersOf (const RigidPose& pose)
{
  return Eigen::Map<const Vector6> (pose.parameters.data());
}

/** Flat as the factor of a CompressedBlock. */
PCL_MSF_FLATTEN Matrix6
inverseOf (const Matrix6& a)
{
  const Vector6 scale = a.diagonal().cwiseMax (1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::Matrix<double, 6, 6> scaled =
      scale.asDiagonal() * a * scale.asDiagonal();
  const Eigen::Matrix<double, 6, 6> inverse =
      Eigen::LDLT<Eigen::Matrix<double, 6, 6>> (scaled).solve (
          Eigen::Matrix<double, 6, 6>::Identity());
  const Matrix6 result = scale.asDiagonal() * inverse * scale.asDiagonal();
  return 0.5 * (result + result.transpose());
}

/** What the covariances of one result are made of. */
class PoseCovariance {
public:
  PoseCovariance (const DataTerm& data,
                  const std::vector<SegmentLink>& links,
                  const MotionState& state,
                  double residual_scale,
                  const InformationTuning& tuning,
                  const SceneFlow& result);

  /** \brief Of its body's pose, by the body's points. */
  Matrix6
  ofBody (int segment) const;

  /** \brief By its own points, as if residuals were independent. */
  Matrix6
  dataOf (int segment) const
  {
    return scale_ * data_.of (segment).information;
  }

  /** \brief What comes to it because the segment may move with others. */
  Matrix6
  ofMembership (int segment) const;

  /** \brief Information of a motion that is anything within reach. */
  Matrix6
  reachOf (int segment) const;

private:
  /** What a segment may be taken for. */
  struct Ways {
    std::vector<Vector6> differences; ///< of the parameters, to other bodies' poses
    std::vector<double> probabilities;
  };
  Ways
  waysOf (int segment) const;
  double
  extraCost (int segment, const Vector6& difference) const;
  Matrix6
  toLocal (int segment) const;
  Matrix6
  fromLocal (int segment) const;
  Matrix6
  spreadOf (int segment, const Ways& ways) const;
  const DataTerm& data_;
  const MotionState& state_;
  const double scale_;
  const InformationTuning& tuning_;
  const SceneFlow& result_;
  const std::vector<BodyInformation> bodies_;
  const std::vector<std::vector<int>> neighbors_;
  int largest_{0}; ///< body
};

PoseCovariance::PoseCovariance (const DataTerm& data,
                                const std::vector<SegmentLink>& links,
                                const MotionState& state,
                                double residual_scale,
                                const InformationTuning& tuning,
                                const SceneFlow& result)
: data_ (data)
, state_ (state)
, scale_ (residual_scale)
, tuning_ (tuning)
, result_ (result)
, bodies_ (informationOfBodies (data, state, residual_scale, tuning))
, neighbors_ (neighborLists (links, data.pixels().segments()))
{
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (bodies_[b].points > bodies_[largest_].points)
      largest_ = static_cast<int> (b);
}

/** A turn about the moved centroid and its shift, from pose parameters: rows. */
Matrix6
PoseCovariance::toLocal (int k) const
{
  const RigidPose& pose = state_.poseOf (k);
  const Eigen::Matrix3d j =
      leftJacobian ({pose.parameters[0], pose.parameters[1], pose.parameters[2]});
  Matrix6 local = Matrix6::Zero();
  local.topLeftCorner<3, 3>() = j;
  local.bottomRows<3>() =
      pointJacobian (j, pose.rotation() * data_.pixels().centroid[k]);
  return local;
}

/** Its inverse. */
Matrix6
PoseCovariance::fromLocal (int k) const
{
  const RigidPose& pose = state_.poseOf (k);
  const Eigen::Matrix3d j =
      leftJacobian ({pose.parameters[0], pose.parameters[1], pose.parameters[2]});
  Matrix6 basis = Matrix6::Identity();
  basis.topLeftCorner<3, 3>() = j.inverse();
  basis.bottomLeftCorner<3, 3>() = skew (pose.rotation() * data_.pixels().centroid[k]);
  return basis;
}

Matrix6
PoseCovariance::reachOf (int k) const
{
  const Eigen::Vector3d& c = data_.pixels().centroid[k];
  const double pixel = std::max (c.z(), 1e-3) / data_.image().fx;
  const double radius =
      0.5 * pixel * std::sqrt (std::max (1.0, 1.0 * data_.pixels().pixels (k)));
  Vector6 local;
  local.head<3>().setConstant (std::pow (radius / (tuning_.reach * pixel), 2));
  local.tail<3>().setConstant (std::pow (1.0 / (tuning_.reach * pixel), 2));
  const Matrix6 to_local = toLocal (k);
  return to_local.transpose() * local.asDiagonal() * to_local;
}

/** By how much more the segment's residuals cost with another pose, in half squared
 * deviations; robust, as they are. */
double
PoseCovariance::extraCost (int k, const Vector6& d) const
{
  const SegmentQuadratic& q = data_.of (k);
  const double cost = scale_ * (0.5 * d.dot (q.information * d) + q.gradient.dot (d));
  const SegmentPixels& p = data_.pixels();
  const int terms = (p.brightness_count > 0) + (p.icp_count > 0);
  const double most =
      tuning_.most_extra * scale_ * data_.totalWeight (k) / std::max (1, terms);
  return cost > 0.0 ? cost / (1.0 + cost / std::max (most, 1e-9)) : 0.0;
}

PoseCovariance::Ways
PoseCovariance::waysOf (int k) const
{
  const int own = state_.body_of[k];
  std::vector<int> others{largest_};
  for (const int n : neighbors_[k])
    others.push_back (state_.body_of[n]);
  std::sort (others.begin(), others.end());
  others.erase (std::unique (others.begin(), others.end()), others.end());
  others.erase (std::remove (others.begin(), others.end(), own), others.end());
  Ways ways;
  double sum = 1.0;
  for (const int b : others) {
    ways.differences.push_back (parametersOf (state_.poses[b]) -
                                parametersOf (state_.poses[own]));
    ways.probabilities.push_back (std::exp (-extraCost (k, ways.differences.back())));
    sum += ways.probabilities.back();
  }
  const double least =
      tuning_.elsewhere / std::sqrt (std::max<std::size_t> (1, others.size()));
  for (double& p : ways.probabilities)
    p = std::max (p / sum, least);
  return ways;
}

/** Covariance of a motion as different as those nearby, in any direction. */
Matrix6
PoseCovariance::spreadOf (int k, const Ways& ways) const
{
  const Matrix6 to_local = toLocal (k);
  Vector6 local = Vector6::Zero();
  for (const Vector6& difference : ways.differences) {
    const Vector6 d = to_local * difference;
    local.head<3>().array() += d.head<3>().squaredNorm() / 3.0;
    local.tail<3>().array() += d.tail<3>().squaredNorm() / 3.0;
  }
  local /= std::max<double> (1.0, static_cast<double> (ways.differences.size()));
  const Matrix6 basis = fromLocal (k);
  return basis * local.asDiagonal() * basis.transpose();
}

Matrix6
PoseCovariance::ofBody (int k) const
{
  return inverseOf (bodies_[state_.body_of[k]].worth() + reachOf (k));
}

Matrix6
PoseCovariance::ofMembership (int k) const
{
  const Ways ways = waysOf (k);
  Matrix6 sum = Matrix6::Zero();
  for (std::size_t i = 0; i < ways.differences.size(); ++i)
    sum +=
        ways.probabilities[i] * ways.differences[i] * ways.differences[i].transpose();
  const SegmentMotion& segment = result_.segments[k];
  const double unseen =
      1.0 - static_cast<double> (segment.visible_points) / std::max (1, segment.points);
  sum += tuning_.not_found * unseen * unseen * spreadOf (k, ways);
  // A motion of its own, by its own points.
  const Matrix6 alone = inverseOf (scale_ * data_.of (k).information + reachOf (k));
  const Vector6 score = scale_ * data_.of (k).gradient;
  const double misfit = std::max (1.0, score.dot (alone * score) / 6.0);
  return sum + std::min (1.0, tuning_.own * misfit * misfit) * alone;
}

/** A group's pose is as sure as its largest body's. Its segments may belong elsewhere:
 * all of them, by their mean, or each alone, which moves the body
 * by its share in the body's information. */
std::vector<GroupMotion>
groupMotions (const MotionState& state,
              const PoseCovariance& covariance,
              const std::vector<Matrix6>& bodies,
              const std::vector<Matrix6>& memberships,
              const SceneFlow& result)
{
  std::vector<int> points (state.poses.size(), 0);
  for (std::size_t k = 0; k < result.segments.size(); ++k)
    points[state.body_of[k]] += result.segments[k].points;
  std::vector<GroupMotion> groups (std::max (0, result.groups));
  std::vector<int> in_largest (groups.size(), -1); // a segment of the largest body
  for (std::size_t k = 0; k < result.segments.size(); ++k) {
    const int g = result.segments[k].group;
    ++groups[g].segments;
    if (in_largest[g] < 0 ||
        points[state.body_of[k]] > points[state.body_of[in_largest[g]]])
      in_largest[g] = static_cast<int> (k);
  }
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const int body = state.body_of[in_largest[g]];
    groups[g].current_from_reference = state.poses[body];
    Matrix6 together = Matrix6::Zero();
    Matrix6 alone = Matrix6::Zero();
    Matrix6 data = Matrix6::Zero();
    int known = -1;
    double segments = 0.0;
    for (std::size_t k = 0; k < result.segments.size(); ++k)
      if (state.body_of[k] == body && memberships[k].allFinite()) {
        together += inverseOf (memberships[k]);
        const Matrix6 own = covariance.dataOf (static_cast<int> (k));
        alone += own * memberships[k] * own;
        data += own;
        known = static_cast<int> (k);
        segments += 1.0;
      }
    if (known < 0)
      continue;
    const Matrix6 inverse = inverseOf (data + covariance.reachOf (known));
    groups[g].information = inverseOf (bodies[known] + inverseOf (together / segments) +
                                       inverse * alone * inverse);
  }
  return groups;
}

} // namespace

Eigen::Matrix<double, 3, 6>
pointJacobian (const Eigen::Matrix3d& left_jacobian, const Eigen::Vector3d& turned)
{
  Eigen::Matrix<double, 3, 6> j;
  j.leftCols<3>() = -skew (turned) * left_jacobian;
  j.rightCols<3>().setIdentity();
  return j;
}

std::vector<Matrix6>
fillInformation (const DataTerm& data,
                 const std::vector<SegmentLink>& links,
                 const MotionState& state,
                 double residual_scale,
                 const InformationTuning& tuning,
                 int threads,
                 SceneFlow& result)
{
  const PoseCovariance covariance (data, links, state, residual_scale, tuning, result);
  const int segments = data.pixels().segments();
  const Matrix6 unknown = Matrix6::Constant (std::numeric_limits<double>::quiet_NaN());
  std::vector<Matrix6> bodies (segments, unknown);
  std::vector<Matrix6> memberships (segments, unknown);
  std::vector<Matrix6> covariances (segments, unknown);
  parallelFor (threads, segments, 8, [&] (int k) {
    SegmentMotion& segment = result.segments[k];
    segment.information.setZero();
    if (segment.points == 0 || segment.status == MotionStatus::Undetermined)
      return;
    bodies[k] = covariance.ofBody (k);
    memberships[k] = covariance.ofMembership (k);
    covariances[k] = bodies[k] + memberships[k];
    segment.information = inverseOf (covariances[k]);
  });
  result.group_motions = groupMotions (state, covariance, bodies, memberships, result);
  return covariances;
}

} // namespace pcl_msf
