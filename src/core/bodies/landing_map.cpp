// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/bodies/landing_map.h"

#include <Eigen/Core>

#include "core/base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_msf {

namespace {

/** Carries points of a segment to the current frame. */
class Landing {
public:
  Landing (const DataTerm& data, const RigidPose& pose)
  : p_ (data.pixels())
  , image_ (data.image())
  , rotation_ (pose.rotation().cast<float>())
  , translation_ (pose.translation().cast<float>())
  {}

  /** Whether point i lands on the surface that the frame shows; sets where. */
  bool
  onSurface (int i)
  {
    const Eigen::Vector3f q =
        rotation_ * Eigen::Vector3f (p_.x[i], p_.y[i], p_.z[i]) + translation_;
    if (!(q.z() > 1e-3f))
      return false;
    at_ = projectTo (image_, q);
    return isOnPixel (image_, at_) &&
           isOnSurface (inverseDepthAt (image_, at_), q.z(), p_.depth_tolerance[i]);
  }

  /** Whether the surface there looks like the point. */
  bool
  alike (int i, float sigmas) const
  {
    const ImagePlace inside{
        std::clamp (at_.u, 0.0f, static_cast<float> (image_.width) - 1.001f),
        std::clamp (at_.v, 0.0f, static_cast<float> (image_.height) - 1.001f)};
    return std::abs (intensityAt (image_, inside) - p_.intensity[i]) *
               p_.brightness_scale[i] <
           sigmas;
  }

  const ImagePlace&
  place () const
  {
    return at_;
  }

private:
  const SegmentPixels& p_;
  const kernel::Image image_;
  const Eigen::Matrix3f rotation_;
  const Eigen::Vector3f translation_;
  ImagePlace at_;
};

} // namespace

LandingMap::LandingMap (const DataTerm& data, const LandingTuning& tuning)
: data_ (data)
, tuning_ (tuning)
, columns_ (data.image().width / tuning.cell + 1)
, landed_ (data.pixels().segments())
, cells_ (static_cast<std::size_t> (columns_) * (data.image().height / tuning.cell + 1))
{}

void
LandingMap::enter (const MotionState& state, std::vector<double> costs, int threads)
{
  const SegmentPixels& p = data_.pixels();
  state_ = &state;
  costs_ = std::move (costs);
  points_.assign (state.poses.size(), 0);
  for (int k = 0; k < p.segments(); ++k)
    points_[state.body_of[k]] += p.pixels (k);
  parallelFor (threads, p.segments(), 8, [&] (int k) {
    if (landed_[k].body != state.body_of[k])
      landed_[k] = {state.body_of[k], landingsOf (k, state.poseOf (k))};
  });
  std::fill (cells_.begin(), cells_.end(), Cell{});
  for (int k = 0; k < p.segments(); ++k)
    for (const int cell : landed_[k].cells)
      enterCell (k, cell);
}

/** A sample of a segment's points is enough. */
std::vector<int>
LandingMap::landingsOf (int segment, const RigidPose& pose) const
{
  const SegmentPixels& p = data_.pixels();
  Landing landing (data_, pose);
  const int step = std::max (1, p.size (segment) / tuning_.per_segment);
  std::vector<int> cells;
  cells.reserve (p.size (segment) / step + 1);
  for (int i = p.begin[segment]; i < p.begin[segment + 1]; i += step) {
    if (!landing.onSurface (i) || !landing.alike (i, tuning_.looks_alike))
      continue;
    const int cell = cellOf (landing.place());
    if (cells.empty() || cells.back() != cell) // once is enough
      cells.push_back (cell);
  }
  return cells;
}

int
LandingMap::cellOf (const ImagePlace& at) const
{
  return (static_cast<int> (at.v + 0.5f) / tuning_.cell) * columns_ +
         static_cast<int> (at.u + 0.5f) / tuning_.cell;
}

bool
LandingMap::larger (int segment, int other) const
{
  if (other < 0)
    return true;
  const int a = points_[state_->body_of[segment]];
  const int b = points_[state_->body_of[other]];
  return a != b ? a > b : segment < other;
}

void
LandingMap::enterCell (int segment, int cell)
{
  auto& entered = cells_[cell].segment;
  if (segment == entered[0] || segment == entered[1])
    return;
  if (larger (segment, entered[0])) {
    entered[1] = entered[0];
    entered[0] = segment;
  }
  else if (larger (segment, entered[1]))
    entered[1] = segment;
}

double
LandingMap::occupiedShare (const DataTerm& sample,
                           int segment,
                           int body,
                           double cost) const
{
  const SegmentPixels& p = sample.pixels();
  Landing landing (sample, state_->poses[body]);
  int occupied = 0;
  for (int i = p.begin[segment]; i < p.begin[segment + 1]; ++i) {
    if (!landing.onSurface (i))
      continue;
    for (const int other : cells_[cellOf (landing.place())].segment)
      if (other >= 0 && other != segment && costs_[other] <= cost + tuning_.worse &&
          points_[state_->body_of[other]] > points_[body]) {
        ++occupied;
        break;
      }
  }
  return static_cast<double> (occupied) / std::max (1, p.size (segment));
}

} // namespace pcl_msf
