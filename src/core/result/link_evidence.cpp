// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/result/link_evidence.h"

#include <Eigen/Core>

#include "core/base/parallel_for.h"
#include "core/data/data_kernel_impl.h"
#include "core/data/surface_sample.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

/** A segment's motion, in single precision, and its centre in the reference image. */
struct Side {
  Eigen::Matrix3f rotation;
  Eigen::Vector3f translation;
  Eigen::Vector2f center;
};

class LinkClassifier {
public:
  LinkClassifier (const DataTerm& data,
                  const MotionState& state,
                  const SoftTuning& tuning);

  LinkEvidence
  classify (const SegmentLink& link) const;

private:
  struct Costs {
    double own{0.0};
    double mixed{0.0};
    int points{0};
  };
  void
  addSide (const Side& own, const Side& other, int segment, Costs& costs) const;
  bool
  inView (const Eigen::Vector3f& moved) const;
  float
  misfit (int point, const Eigen::Vector3f& moved, const Eigen::Vector3f& normal) const;

  const DataTerm& data_;
  const kernel::Image image_;
  const SoftTuning& tuning_;
  std::vector<Side> sides_; ///< per segment
  std::vector<int> body_of_;
};

LinkClassifier::LinkClassifier (const DataTerm& data,
                                const MotionState& state,
                                const SoftTuning& tuning)
: data_ (data), image_ (data.image()), tuning_ (tuning), body_of_ (state.body_of)
{
  for (int k = 0; k < data.pixels().segments(); ++k) {
    const RigidPose& pose = state.poseOf (k);
    const Eigen::Vector3f c = data.pixels().centroid[k].cast<float>();
    const float z = std::max (c.z(), 1e-3f);
    sides_.push_back (
        {pose.rotation().cast<float>(),
         pose.translation().cast<float>(),
         {image_.fx * c.x() / z + image_.cx, image_.fy * c.y() / z + image_.cy}});
  }
}

/** Does the frame show where a point has gone? */
bool
LinkClassifier::inView (const Eigen::Vector3f& q) const
{
  return q.z() > 1e-3f && isBetweenPixels (image_, projectTo (image_, q));
}

/** Cost of the brightness and the plane distance of a point in view, truncated; the
 * limit instead of the latter when it is not on the frame's surface. */
float
LinkClassifier::misfit (int i,
                        const Eigen::Vector3f& q,
                        const Eigen::Vector3f& normal) const
{
  const SegmentPixels& p = data_.pixels();
  const kernel::Rules& rules = data_.rules();
  const ImagePlace at = projectTo (image_, q);
  const auto cost = [&] (float r) {
    return std::min (kernel::robustCost (r, rules.huber), rules.truncation);
  };
  const float brightness =
      cost ((intensityAt (image_, at) - p.intensity[i]) * p.brightness_scale[i]);
  const float w = inverseDepthAt (image_, at);
  if (!isOnSurface (w, q.z(), p.depth_tolerance[i]))
    return brightness + rules.truncation;
  return brightness + cost (planeDistance (q, normal, w) * p.icp_scale[i]);
}

void
LinkClassifier::addSide (const Side& own, const Side& other, int k, Costs& costs) const
{
  const SegmentPixels& p = data_.pixels();
  const Eigen::Vector2f way = other.center - own.center;
  const float square = std::max (way.squaredNorm(), 1.0f);
  const int step = std::max (1, p.size (k) / tuning_.samples);
  for (int i = p.begin[k]; i < p.begin[k + 1]; i += step) {
    const Eigen::Vector2f at (static_cast<float> (p.pixel[i] % image_.width),
                              static_cast<float> (p.pixel[i] / image_.width));
    const Eigen::Vector2f off = at - own.center;
    const float share = off.dot (way) / square;
    const float aside = off.x() * way.y() - off.y() * way.x();
    if (share < tuning_.near || share > tuning_.far ||
        aside * aside > 0.25f * square * square)
      continue;
    const Eigen::Vector3f point (p.x[i], p.y[i], p.z[i]);
    const Eigen::Vector3f normal =
        own.rotation * Eigen::Vector3f (p.nx[i], p.ny[i], p.nz[i]);
    const Eigen::Vector3f moved = own.rotation * point + own.translation;
    const Eigen::Vector3f as_other = other.rotation * point + other.translation;
    const Eigen::Vector3f mixed = moved + share * (as_other - moved);
    if (!inView (moved) || !inView (mixed)) // counts for neither
      continue;
    costs.own += misfit (i, moved, normal);
    costs.mixed += misfit (i, mixed, normal);
    ++costs.points;
  }
}

LinkEvidence
LinkClassifier::classify (const SegmentLink& link) const
{
  if (body_of_[link.first] == body_of_[link.second])
    return LinkEvidence::None;
  Costs costs;
  addSide (sides_[link.first], sides_[link.second], link.first, costs);
  addSide (sides_[link.second], sides_[link.first], link.second, costs);
  if (costs.points < tuning_.least_samples)
    return LinkEvidence::None;
  const double gain = (costs.own - costs.mixed) / costs.points;
  if (std::abs (gain) < tuning_.clear)
    return LinkEvidence::None;
  return gain > 0.0 ? LinkEvidence::Soft : LinkEvidence::Sharp;
}

} // namespace

std::vector<LinkEvidence>
classifyLinks (const DataTerm& data,
               const std::vector<SegmentLink>& links,
               const MotionState& state,
               const SoftTuning& tuning,
               int threads)
{
  const LinkClassifier classifier (data, state, tuning);
  std::vector<LinkEvidence> evidence (links.size(), LinkEvidence::None);
  const int n = static_cast<int> (links.size());
  parallelFor (
      threads, n, 16, [&] (int i) { evidence[i] = classifier.classify (links[i]); });
  return evidence;
}

} // namespace pcl_msf
