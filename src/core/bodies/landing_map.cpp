// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/bodies/landing_map.h"

#include <Eigen/Core>

#include "core/base/parallel_for.h"

#include <algorithm>
#include <cmath>

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

LandingMap::LandingMap (const DataTerm& data,
                        const MotionState& state,
                        const LandingTuning& tuning,
                        int threads)
: state_ (state)
, points_ (state.poses.size(), 0)
, cell_ (tuning.cell)
, columns_ (data.image().width / cell_ + 1)
, cells_ (static_cast<std::size_t> (columns_) * (data.image().height / cell_ + 1))
{
  const SegmentPixels& p = data.pixels();
  for (int k = 0; k < p.segments(); ++k)
    points_[state.body_of[k]] += p.size (k);
  std::vector<std::vector<int>> cells (p.segments()); // that each lands on
  parallelFor (threads, p.segments(), 8, [&] (int k) {
    Landing landing (data, state.poseOf (k));
    const int step = std::max (1, p.size (k) / tuning.per_segment);
    cells[k].reserve (p.size (k) / step + 1);
    for (int i = p.begin[k]; i < p.begin[k + 1]; i += step)
      if (landing.onSurface (i) && landing.alike (i, tuning.looks_alike))
        cells[k].push_back (cellOf (landing.place()));
  });
  for (int k = 0; k < p.segments(); ++k)
    for (const int cell : cells[k])
      enter (k, cell);
}

int
LandingMap::cellOf (const ImagePlace& at) const
{
  return (static_cast<int> (at.v + 0.5f) / cell_) * columns_ +
         static_cast<int> (at.u + 0.5f) / cell_;
}

bool
LandingMap::larger (int segment, int other) const
{
  if (other < 0)
    return true;
  const int a = points_[state_.body_of[segment]];
  const int b = points_[state_.body_of[other]];
  return a != b ? a > b : segment < other;
}

void
LandingMap::enter (int segment, int cell)
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
LandingMap::occupiedShare (const DataTerm& sample, int segment, int body) const
{
  const SegmentPixels& p = sample.pixels();
  Landing landing (sample, state_.poses[body]);
  int occupied = 0;
  for (int i = p.begin[segment]; i < p.begin[segment + 1]; ++i) {
    if (!landing.onSurface (i))
      continue;
    for (const int other : cells_[cellOf (landing.place())].segment)
      if (other >= 0 && other != segment &&
          points_[state_.body_of[other]] > points_[body]) {
        ++occupied;
        break;
      }
  }
  return static_cast<double> (occupied) / std::max (1, p.size (segment));
}

} // namespace pcl_msf
