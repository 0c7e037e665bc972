// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/data/data_term.h"

#include "core/base/parallel_for.h"

#include <algorithm>

namespace pcl_msf {

namespace {

/** \param n rotation of the normals */
kernel::Motion
kernelMotion (const UnpackedPose& pose,
              const Eigen::Matrix3d& n,
              const Eigen::Vector3d& centroid)
{
  const Eigen::Matrix3d& r = pose.rotation;
  const Eigen::Vector3d& t = pose.translation;
  const Eigen::Vector3d o = r * centroid + t;
  kernel::Motion m{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      m.rotation[3 * i + j] = r (i, j);
      m.normal_rotation[3 * i + j] = n (i, j);
    }
    m.translation[i] = t[i];
    m.origin[i] = o[i];
  }
  return m;
}

void
multiply (kernel::Sums& sums, double factor)
{
  for (double& a : sums.a)
    a *= factor;
  for (double& b : sums.b)
    b *= factor;
  sums.brightness_cost *= factor;
  sums.icp_cost *= factor;
}

/** Sums about a left perturbation at the centroid -> pose parameters. */
void
toPoseParameters (const kernel::Sums& sums,
                  const UnpackedPose& pose,
                  const Eigen::Vector3d& centroid,
                  SegmentQuadratic& out)
{
  Matrix6 a;
  int at = 0;
  for (int r = 0; r < 6; ++r)
    for (int c = r; c < 6; ++c)
      a (r, c) = a (c, r) = sums.a[at++];
  const Eigen::Map<const Vector6> b (sums.b);
  const Eigen::Matrix3d j = leftJacobian (pose.rotation_vector);
  Matrix6 basis = Matrix6::Identity();
  basis.topLeftCorner<3, 3>() = j;
  basis.bottomLeftCorner<3, 3>() = -skew (pose.rotation * centroid) * j;
  out.information = basis.transpose() * a * basis;
  out.gradient = basis.transpose() * b;
}

} // namespace

kernel::Rules
makeRules (const EnergyParameters& energy,
           const SegmentPixels& pixels,
           const MissingTuning& tuning)
{
  constexpr double kNever = 1e15;
  double huber = energy.huber_threshold;
  if (energy.loss == LossType::L2)
    huber = kNever;
  // A zero threshold is the l1 norm; the limit of Eq. 7 divided by epsilon.
  constexpr double kTiny = 1e-3;
  double scale = 1.0;
  if (energy.loss == LossType::L1 || huber == 0.0) {
    huber = kTiny;
    scale = 1.0 / kTiny;
  }
  kernel::Rules rules{};
  rules.huber = static_cast<float> (huber);
  const auto cost_of = [huber] (double sigmas) {
    return static_cast<float> (huber >= sigmas ? 0.5 * sigmas * sigmas
                                               : huber * (sigmas - 0.5 * huber));
  };
  rules.conflict_cost = cost_of (tuning.wrong_match);
  rules.occluded_cost = cost_of (tuning.occluded);
  rules.outside_cost = cost_of (tuning.out_of_view);
  rules.unknown_cost = cost_of (tuning.no_depth);
  rules.truncation = cost_of (tuning.wrong_match);
  const auto weight = [scale] (double term, double area, int count) {
    return static_cast<float> (scale * term / (area * std::max (1, count)));
  };
  rules.brightness_weight = weight (
      energy.brightness_weight, pixels.areas.brightness, pixels.brightness_count);
  rules.icp_weight = weight (energy.icp_weight, pixels.areas.icp, pixels.icp_count);
  return rules;
}

double
residualScale (const EnergyParameters& energy, const SegmentPixels& pixels)
{
  const double alpha = pixels.brightness_count > 0 ? energy.brightness_weight : 0.0;
  const double beta = pixels.icp_count > 0 ? energy.icp_weight : 0.0;
  const int count =
      (alpha > 0.0 ? pixels.brightness_count : 0) + (beta > 0.0 ? pixels.icp_count : 0);
  // A pixel of a coarse level stands for several: fewer of its neighbours err alike.
  const double mean_area =
      (alpha + beta) /
      std::max (alpha / pixels.areas.brightness + beta / pixels.areas.icp, 1e-12);
  return count / std::max (alpha + beta, 1e-12) *
         std::min<double> (pixels.pixel_area, mean_area);
}

Texture::Texture (const FrameLevel& level)
: texels_ (level.height(), level.width(), CV_32FC2), camera_ (level.camera)
{
  for (int y = 0; y < level.height(); ++y) {
    const float* w = level.inverse_depth.ptr<float> (y);
    const float* i = level.intensity.empty() ? nullptr : level.intensity.ptr<float> (y);
    cv::Vec2f* out = texels_.ptr<cv::Vec2f> (y);
    for (int x = 0; x < level.width(); ++x)
      out[x] = {i ? i[x] : 0.0f, w[x]};
  }
}

kernel::Image
Texture::image() const
{
  return {texels_.ptr<float>(),
          texels_.cols,
          texels_.rows,
          static_cast<float> (camera_.fx),
          static_cast<float> (camera_.fy),
          static_cast<float> (camera_.cx),
          static_cast<float> (camera_.cy)};
}

void
Texture::subtract (const cv::Mat& image, float share, int threads)
{
  parallelFor (threads, texels_.rows, 32, [&] (int y) {
    const float* off = image.ptr<float> (y);
    cv::Vec2f* texel = texels_.ptr<cv::Vec2f> (y);
    for (int x = 0; x < texels_.cols; ++x)
      texel[x][0] -= share * off[x];
  });
}

DataTerm::DataTerm (const SegmentPixels& pixels,
                    const Texture& texture,
                    const kernel::Rules& rules,
                    int threads)
: pixels_ (pixels)
, image_ (texture.image())
, rules_ (rules)
, threads_ (threads)
, plane_offset_ (pixels.pixel.size(), 0.0f)
, active_ (pixels.pixel.size(), 0)
, frozen_ (pixels.segments())
, quadratics_ (pixels.segments())
, holds_ (pixels.segments(), Holds::Nothing)
{}

kernel::Points
DataTerm::points (int k) const
{
  static_assert (kernel::kLanes - 1 <= SegmentPixels::kPadding);
  const int at = pixels_.begin[k];
  return {pixels_.x.data() + at,
          pixels_.y.data() + at,
          pixels_.z.data() + at,
          pixels_.intensity.data() + at,
          pixels_.nx.data() + at,
          pixels_.ny.data() + at,
          pixels_.nz.data() + at,
          pixels_.brightness_scale.data() + at,
          pixels_.icp_scale.data() + at,
          pixels_.depth_tolerance.data() + at,
          pixels_.size (k)};
}

void
DataTerm::evaluate (int k, const RigidPose& at_pose, Pass pass)
{
  const bool renew = pass == Pass::Linearize;
  if (renew && holds_[k] != Holds::Nothing &&
      frozen_[k].parameters == at_pose.parameters)
    return;
  holds_[k] = renew ? Holds::All : Holds::Nothing;
  if (renew)
    frozen_[k] = at_pose;
  const UnpackedPose pose (at_pose);
  const bool follow = frozen_[k].parameters == at_pose.parameters;
  const kernel::Motion motion = kernelMotion (
      pose, follow ? pose.rotation : frozen_[k].rotation(), pixels_.centroid[k]);
  const int at = pixels_.begin[k];
  const kernel::Correspondences state{plane_offset_.data() + at, active_.data() + at};
  kernel::Sums sums{};
  const auto linearize =
      renew ? kernel::chosenKernel().linearize : kernel::linearizeKeptInDouble;
  linearize (points (k), image_, motion, rules_, state, sums);
  multiply (sums, pixels_.pixels_per_point[k]);
  SegmentQuadratic& out = quadratics_[k];
  out.brightness_cost = sums.brightness_cost;
  out.icp_cost = sums.icp_cost;
  toPoseParameters (sums, pose, pixels_.centroid[k], out);
  out.flow_cost = 0.0;
  if (const double worth = solving_ * residual_; worth > 0.0)
    out.flow_cost =
        worth * flow_->cost (k, pose, worth, &out.information, &out.gradient);
}

void
DataTerm::sweep (const MotionState& state, Pass pass)
{
  parallelFor (threads_, pixels_.segments(), 8, [&] (int k) {
    evaluate (k, state.poseOf (k), pass);
  });
}

DataTerm::Probe
DataTerm::probe (int k, const UnpackedPose& pose) const
{
  kernel::Sums sums{};
  const kernel::Motion motion = kernelMotion (pose, pose.rotation, pixels_.centroid[k]);
  kernel::chosenKernel().probe (points (k), image_, motion, rules_, sums);
  Probe result;
  result.cost = sums.brightness_cost + sums.icp_cost;
  result.flow = flow_ ? residual_ * flow_->cost (k, pose) : 0.0;
  result.weight = totalWeight (k);
  result.hidden = result.weight > 0.0 ? sums.hidden / result.weight : 1.0;
  return result;
}

} // namespace pcl_msf
