// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/energy/concatenation_cost.h"

#include <algorithm>

namespace pcl_msf {

namespace {

// A body as four vectors: its centre, which translations move, and three spreads, which
// they don't.
using Vectors = Eigen::Matrix<double, 3, 4, Eigen::DontAlign>;
using RowMajor = Eigen::Matrix<double, 12, 6, Eigen::RowMajor>;

RigidPose
poseFrom (const double* parameters)
{
  RigidPose pose;
  std::copy (parameters, parameters + 6, pose.parameters.begin());
  return pose;
}

struct Step {
  Eigen::Matrix3d turn;       ///< of the walk
  Eigen::Matrix3d derivative; ///< d (turned v) = -[turned v]_x derivative da
  Eigen::Matrix3d shift;      ///< d (walked point) / d t
};

/** Walks a step; keeps what its derivatives need. */
Step
walk (const double* parameters, bool inverse, Vectors& v)
{
  const RigidPose pose = poseFrom (parameters);
  const Eigen::Vector3d a (parameters[0], parameters[1], parameters[2]);
  Step step;
  if (inverse) {
    step.turn = pose.rotation().transpose();
    step.derivative = -leftJacobian (-a);
    step.shift = -step.turn;
    v.col (0) -= pose.translation();
    v = (step.turn * v).eval();
    return step;
  }
  step.turn = pose.rotation();
  step.derivative = leftJacobian (a);
  step.shift = Eigen::Matrix3d::Identity();
  v = (step.turn * v).eval();
  v.col (0) += pose.translation();
  return step;
}

/** d residuals / d pose of a step that ended at `v`; `rest` turns it to the end. */
void
stepJacobian (const Step& step,
              const Vectors& v,
              const Eigen::Vector3d& shift,
              const Eigen::Matrix3d& rest,
              double scale,
              double* out)
{
  Eigen::Map<RowMajor> j (out);
  j.setZero();
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector3d turned =
        i == 0 ? v.col (0) - shift : Eigen::Vector3d (v.col (i));
    j.block<3, 3> (3 * i, 0) = -scale * rest * skew (turned) * step.derivative;
  }
  j.block<3, 3> (0, 3) = scale * rest * step.shift;
}

/** What a step adds to a point after turning it. */
Eigen::Vector3d
shiftAfterTurn (const double* parameters, bool inverse)
{
  return inverse ? Eigen::Vector3d::Zero() : poseFrom (parameters).translation();
}

} // namespace

ConcatenationCost::ConcatenationCost (const BodyShape& shape,
                                      const std::vector<bool>& inverse,
                                      double scale)
: shape_ (shape), inverse_ (inverse), scale_ (scale)
{
  set_num_residuals (12);
  mutable_parameter_block_sizes()->assign (1 + inverse.size(), 6);
}

bool
ConcatenationCost::Evaluate (double const* const* parameters,
                             double* residuals,
                             double** jacobians) const
{
  const std::size_t steps = inverse_.size();
  Vectors body;
  body << shape_.center, shape_.spread;
  Vectors own = body;
  const Step direct = walk (parameters[0], false, own);
  std::vector<Vectors> ends;
  std::vector<Step> walked;
  Vectors chained = body;
  for (std::size_t s = 0; s < steps; ++s) {
    walked.push_back (walk (parameters[s + 1], inverse_[s], chained));
    ends.push_back (chained);
  }
  Eigen::Map<Vectors> r (residuals);
  r = scale_ * (own - chained);
  if (!jacobians)
    return true;
  if (jacobians[0])
    stepJacobian (direct,
                  own,
                  shiftAfterTurn (parameters[0], false),
                  Eigen::Matrix3d::Identity(),
                  scale_,
                  jacobians[0]);
  Eigen::Matrix3d rest = Eigen::Matrix3d::Identity();
  for (std::size_t s = steps; s-- > 0;) {
    if (jacobians[s + 1])
      stepJacobian (walked[s],
                    ends[s],
                    shiftAfterTurn (parameters[s + 1], inverse_[s]),
                    rest,
                    -scale_,
                    jacobians[s + 1]);
    rest = (rest * walked[s].turn).eval();
  }
  return true;
}

RigidPose
concatenate (const std::vector<RigidPose>& steps, const std::vector<bool>& inverse)
{
  RigidPose result;
  for (std::size_t s = 0; s < steps.size(); ++s)
    result = (inverse[s] ? steps[s].inverse() : steps[s]) * result;
  return result;
}

} // namespace pcl_msf
