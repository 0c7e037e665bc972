// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <Eigen/Geometry>

#include "core/base/number_text.h"
#include "core/base/order_statistics.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/synthetic/body_clouds.h>
#include <synthetic/body_shapes.h>
#include <synthetic/random.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl_msf::synthetic {
namespace {

constexpr double kRadians = M_PI / 180.0;

/** A point on a link's box, at rest. */
struct DrawnPoint {
  int link{0};
  Eigen::Vector3d rest;
};

class Body {
public:
  explicit Body (BodyKind kind) : links_ (bodyLinks (kind))
  {
    for (const BodyLink& link : links_) {
      const Eigen::Vector3d& h = link.half;
      const double area = h.x() * h.y() + h.y() * h.z() + h.z() * h.x();
      areas_.push_back (area + (areas_.empty() ? 0.0 : areas_.back()));
    }
  }

  const std::vector<BodyLink>&
  links () const
  {
    return links_;
  }

  /** By area, on the outside of the whole body in a pose. */
  std::vector<DrawnPoint>
  draw (int count, const std::vector<RigidPose>& poses, Random& random) const
  {
    std::vector<RigidPose> back;
    for (const RigidPose& pose : poses)
      back.push_back (pose.inverse());
    std::vector<DrawnPoint> points;
    while (static_cast<int> (points.size()) < count) {
      const DrawnPoint point = drawOne (random);
      if (!hidden (point, poses[point.link] * point.rest, back))
        points.push_back (point);
    }
    return points;
  }

private:
  DrawnPoint
  drawOne (Random& random) const
  {
    DrawnPoint point;
    const double place = random.uniform (0.0, areas_.back());
    while (place >= areas_[point.link])
      ++point.link;
    const Eigen::Vector3d& h = links_[point.link].half;
    const Eigen::Vector3d faces (h.y() * h.z(), h.z() * h.x(), h.x() * h.y());
    double side = random.uniform (0.0, faces.sum());
    int axis = 0;
    while (axis < 2 && side >= faces[axis])
      side -= faces[axis++];
    Eigen::Vector3d p;
    for (int k = 0; k < 3; ++k)
      p[k] = random.uniform (-1.0, 1.0);
    p[axis] = random.sign();
    point.rest = links_[point.link].center + p.cwiseProduct (h);
    return point;
  }
  bool
  hidden (const DrawnPoint& point,
          const Eigen::Vector3d& moved,
          const std::vector<RigidPose>& back) const
  {
    for (std::size_t l = 0; l < links_.size(); ++l) {
      if (static_cast<int> (l) == point.link)
        continue;
      const Eigen::Vector3d d = back[l] * moved - links_[l].center;
      if ((d.cwiseAbs() - links_[l].half).maxCoeff() < -1e-9)
        return true;
    }
    return false;
  }

  std::vector<BodyLink> links_;
  std::vector<double> areas_; ///< of the links, summed up
};

RigidPose
turnAbout (const Eigen::Vector3d& axis, double angle, const Eigen::Vector3d& point)
{
  const Eigen::Matrix3d r = Eigen::AngleAxisd (angle, axis).toRotationMatrix();
  return RigidPose::fromMatrix (r, point - r * point);
}

/** How the joints turn and the whole moves from one target to the next. */
struct BodyMotion {
  Eigen::Vector3d axis; ///< of the whole, about the first link's centre, 5 degrees
  Eigen::Vector3d shift;
  std::vector<double> angles; ///< per link with a parent, radians
};

BodyMotion
drawMotion (const Body& body, double most, Random& random)
{
  BodyMotion motion;
  for (const BodyLink& link : body.links())
    if (link.parent < 0) {
      motion.axis = random.direction();
      motion.shift = 0.025 * random.direction();
    }
    else
      motion.angles.push_back (random.sign() * random.uniform (0.5, 1.0) * most *
                               kRadians);
  return motion;
}

/** Turns the joints and moves the whole. \param times as far as between neighbours */
void
bend (const Body& body, const BodyMotion& motion, double times, BodyClouds& clouds)
{
  const std::vector<BodyLink>& links = body.links();
  for (std::size_t l = 0; l < links.size(); ++l) {
    const BodyLink& link = links[l];
    if (link.parent < 0) {
      const RigidPose turn =
          turnAbout (motion.axis, times * 5.0 * kRadians, link.center);
      clouds.poses.push_back (RigidPose::fromMatrix (
          turn.rotation(), turn.translation() + times * motion.shift));
      continue;
    }
    BodyJoint joint;
    joint.child = static_cast<int> (l);
    joint.parent = link.parent;
    joint.axis = link.axis;
    joint.angle = times * motion.angles[clouds.joints.size()];
    joint.point = link.joint;
    clouds.poses.push_back (clouds.poses[link.parent] *
                            turnAbout (joint.axis, joint.angle, joint.point));
    clouds.joints.push_back (joint);
  }
}

Eigen::Vector3d
noiseOf (double deviation, Random& random)
{
  Eigen::Vector3d noise = Eigen::Vector3d::Zero();
  for (int k = 0; k < 12 && deviation > 0.0; ++k)
    for (int c = 0; c < 3; ++c)
      noise[c] += random.uniform (-0.5, 0.5);
  return deviation * noise;
}

/** What lies farther along a direction is missing in the target. */
void
cutOff (double share, Random& random, BodyClouds& clouds)
{
  const Eigen::Vector3f direction = random.direction().cast<float>();
  std::vector<float> along;
  for (const auto& p : clouds.target)
    along.push_back (p.dot (direction));
  const float limit = quantile (along, 1.0 - share);
  const auto beyond = [&] (const Eigen::Vector3f& p) {
    return p.dot (direction) > limit;
  };
  clouds.target.erase (
      std::remove_if (clouds.target.begin(), clouds.target.end(), beyond),
      clouds.target.end());
  for (auto& p : clouds.truth)
    if (beyond (p))
      p.setConstant (std::numeric_limits<float>::quiet_NaN());
}

/** Dust in a box around the target. */
void
addOutliers (int count, Random& random, BodyClouds& clouds)
{
  Eigen::Vector3f low = clouds.target.front();
  Eigen::Vector3f high = low;
  for (const auto& p : clouds.target) {
    low = low.cwiseMin (p);
    high = high.cwiseMax (p);
  }
  const Eigen::Vector3f rim = 0.2F * (high - low);
  for (int i = 0; i < count; ++i) {
    Eigen::Vector3f p;
    for (int k = 0; k < 3; ++k)
      p[k] = static_cast<float> (random.uniform (low[k] - rim[k], high[k] + rim[k]));
    clouds.target.push_back (p);
  }
}

} // namespace

const char*
toString (BodyKind body)
{
  switch (body) {
  case BodyKind::Hand:
    return "hand";
  case BodyKind::Animal:
    return "animal";
  default:
    return "chain";
  }
}

const std::vector<BodyKind>&
allBodies ()
{
  static const std::vector<BodyKind> bodies{
      BodyKind::Chain, BodyKind::Hand, BodyKind::Animal};
  return bodies;
}

bool
BodyOptions::isValid (std::string* why) const
{
  const auto inside = [why] (const char* name, double value, double low, double high) {
    if (value >= low && value <= high)
      return true;
    if (why)
      *why = std::string (name) + ": must be in [" + generalText (low) + ", " +
             generalText (high) + "]";
    return false;
  };
  return inside ("points", points, 100.0, 1e7) && inside ("angle", angle, 0.0, 170.0) &&
         inside ("noise", noise, 0.0, 1.0) && inside ("outliers", outliers, 0.0, 1.0) &&
         inside ("cut", cut, 0.0, 0.9);
}

BodyClouds
synthesizeBody (const BodyOptions& options)
{
  return synthesizeBodySequence (options, 1).front();
}

std::vector<BodyClouds>
synthesizeBodySequence (const BodyOptions& options, int targets)
{
  std::string why = "there must be a target or more";
  if (targets < 1 || !options.isValid (&why))
    throw InvalidInput (why);
  const Body body (options.body);
  Random random (options.seed);
  const BodyMotion motion = drawMotion (body, options.angle, random);
  std::vector<Eigen::Vector3d> source;
  std::vector<int> link;
  const std::vector<RigidPose> rest (body.links().size());
  for (const DrawnPoint& p : body.draw (options.points, rest, random)) {
    source.push_back (p.rest + noiseOf (options.noise, random));
    link.push_back (p.link);
  }
  std::vector<BodyClouds> sequence;
  for (int k = 1; k <= targets; ++k) {
    BodyClouds clouds;
    clouds.link = link;
    bend (body, motion, k, clouds);
    for (std::size_t i = 0; i < source.size(); ++i) {
      clouds.source.push_back (source[i].cast<float>());
      clouds.truth.push_back ((clouds.poses[link[i]] * source[i]).cast<float>());
    }
    for (const DrawnPoint& p : body.draw (options.points, clouds.poses, random))
      clouds.target.push_back (
          (clouds.poses[p.link] * p.rest + noiseOf (options.noise, random))
              .cast<float>());
    if (options.cut > 0.0)
      cutOff (options.cut, random, clouds);
    addOutliers (static_cast<int> (options.outliers * options.points), random, clouds);
    sequence.push_back (std::move (clouds));
  }
  return sequence;
}

} // namespace pcl_msf::synthetic
