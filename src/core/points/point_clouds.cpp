// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/point_clouds.h"

#include "core/base/number_text.h"
#include "core/points/given_segments.h"
#include "core/surface/thinning.h"
#include <pcl_msf/errors.h>

#include <algorithm>
#include <limits>
#include <string>
#include <tuple>

namespace pcl_msf {

namespace {

constexpr std::size_t kFewest = 20;  // points that make a surface
constexpr int kMostStray = 100;      // of so many points one may be a stray, per side
constexpr float kStrayRanges = 5.0f; // of all others from them: a stray is farther off

std::vector<int>
finitePoints (const std::vector<Eigen::Vector3f>& points)
{
  std::vector<int> finite;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite())
      finite.push_back (static_cast<int> (i));
  return finite;
}

/** Leaves out points so far from nearly all others that these would shrink to a speck
 * beside them: a few measurements of nothing. */
void
dropStrays (const std::vector<Eigen::Vector3f>& points, std::vector<int>& chosen)
{
  const auto count = static_cast<std::ptrdiff_t> (chosen.size());
  const std::ptrdiff_t few = count / kMostStray;
  Eigen::Vector3f low;
  Eigen::Vector3f high;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<float> values;
    for (const int i : chosen)
      values.push_back (points[i][axis]);
    std::nth_element (values.begin(), values.begin() + few, values.end());
    low[axis] = values[few];
    std::nth_element (values.begin(), values.end() - few - 1, values.end());
    high[axis] = values[count - few - 1];
  }
  const float margin = kStrayRanges * (high - low).maxCoeff();
  if (!(margin > 0.0f))
    return;
  const auto stray = [&] (int i) {
    return (low - points[i]).maxCoeff() > margin ||
           (points[i] - high).maxCoeff() > margin;
  };
  chosen.erase (std::remove_if (chosen.begin(), chosen.end(), stray), chosen.end());
}

/** Of points at one place the first. */
void
dropDoubles (const std::vector<Eigen::Vector3f>& points, std::vector<int>& chosen)
{
  const auto key = [&points] (int i) {
    const Eigen::Vector3f& p = points[i];
    return std::make_tuple (p.x(), p.y(), p.z());
  };
  std::sort (chosen.begin(), chosen.end(), [&key] (int a, int b) {
    return std::make_pair (key (a), a) < std::make_pair (key (b), b);
  });
  chosen.erase (std::unique (chosen.begin(),
                             chosen.end(),
                             [&key] (int a, int b) { return key (a) == key (b); }),
                chosen.end());
  std::sort (chosen.begin(), chosen.end());
}

/** None of none. */
std::vector<Eigen::Vector3f>
pick (const std::vector<Eigen::Vector3f>& points, const std::vector<int>& chosen)
{
  std::vector<Eigen::Vector3f> picked;
  if (points.empty())
    return picked;
  picked.reserve (chosen.size());
  for (const int i : chosen)
    picked.push_back (points[i]);
  return picked;
}

void
requireEnough (std::size_t count, const std::string& name)
{
  if (count < kFewest)
    throw InvalidInput ("the " + name + " has " + std::to_string (count) +
                        " points that are finite, different and on a surface: give " +
                        std::to_string (kFewest) + " or more");
}

/** Far from the origin, as in maps of the earth, single precision leaves no shape. */
void
requireFineSteps (double farthest, double size)
{
  constexpr double kCoarse = 1e-3; // of the size
  const double step = farthest * std::numeric_limits<float>::epsilon();
  if (step < kCoarse * size)
    return;
  PlainStream text;
  text << "the source's coordinates reach " << farthest
       << ", where single precision has steps of " << step << ", and it is only "
       << size << " large: subtract an offset from both clouds first";
  throw InvalidInput (text.str());
}

/** \throws InvalidInput when there are normals, but not one per point */
void
requireNormals (const InputPoints& cloud, const std::string& name)
{
  if (!cloud.normals.empty() && cloud.normals.size() != cloud.points.size())
    throw InvalidInput ("the " + name + " has " + std::to_string (cloud.points.size()) +
                        " points and " + std::to_string (cloud.normals.size()) +
                        " normals: give one per point, or none");
}

/** \param points scaled \param segments per point, of the chosen >= 0, or empty */
WorkingCloud
makeWorkingCloud (const std::vector<Eigen::Vector3f>& points,
                  const std::vector<Eigen::Vector3f>& normals,
                  const std::vector<int>& chosen,
                  const std::vector<int>& segments,
                  const std::string& name,
                  const Tuning& tuning,
                  int threads)
{
  WorkingCloud cloud;
  std::vector<int> thinned;
  for (const int k :
       thinPoints (pick (points, chosen), {}, tuning.points.clouds.most_points))
    thinned.push_back (chosen[k]);
  dropDoubles (points, thinned);
  requireEnough (thinned.size(), name);
  std::vector<int> kept;
  cloud.surface = makeCleanSurface (
      pick (points, thinned), tuning.surface, threads, kept, pick (normals, thinned));
  for (const int k : kept)
    cloud.given.push_back (thinned[k]);
  requireEnough (cloud.given.size(), name);
  cloud.samples = thinPoints (
      cloud.surface.points, cloud.surface.normals, tuning.points.clouds.samples);
  if (!segments.empty()) {
    for (const int i : cloud.given)
      cloud.segment.push_back (segments[i]);
    closeGaps (cloud.segment);
    bridgeSegments (cloud.surface, cloud.segment, tuning.surface, threads);
    cloud.samples =
        sampleEach (cloud.samples, cloud.segment, tuning.points.clouds.least_samples);
  }
  cloud.thin = thinSurface (cloud.surface, cloud.samples, tuning.surface, threads);
  return cloud;
}

std::vector<Eigen::Vector3f>
scaledPoints (const PointClouds& clouds, const std::vector<Eigen::Vector3f>& points)
{
  std::vector<Eigen::Vector3f> scaled;
  scaled.reserve (points.size());
  for (const auto& p : points)
    scaled.push_back (clouds.scaled (p));
  return scaled;
}

WorkingCloud
makeTarget (const PointClouds& clouds,
            const InputPoints& target,
            const std::string& name,
            const Tuning& tuning,
            int threads)
{
  return makeWorkingCloud (scaledPoints (clouds, target.points),
                           target.normals,
                           finitePoints (target.points),
                           {},
                           name,
                           tuning,
                           threads);
}

} // namespace

RigidPose
PointClouds::asGiven (const RigidPose& pose) const
{
  const Eigen::Matrix3d r = pose.rotation();
  return RigidPose::fromMatrix (r, size * pose.translation() + center - r * center);
}

RigidPose
PointClouds::scaled (const RigidPose& pose) const
{
  const Eigen::Matrix3d r = pose.rotation();
  return RigidPose::fromMatrix (r, (pose.translation() - center + r * center) / size);
}

const std::vector<Eigen::Vector3f>&
InputPoints::none()
{
  static const std::vector<Eigen::Vector3f> empty;
  return empty;
}

PointClouds
preparePointClouds (const InputPoints& source,
                    const InputPoints& target,
                    const Tuning& tuning,
                    int threads,
                    const std::vector<int>& segments,
                    const std::string& name)
{
  const char* const own_name = segments.empty() ? "source" : "segmented source";
  requireNormals (source, own_name);
  requireNormals (target, name);
  PointClouds clouds;
  std::vector<int> finite = finitePoints (source.points);
  if (!segments.empty())
    finite.erase (std::remove_if (finite.begin(),
                                  finite.end(),
                                  [&segments] (int i) { return segments[i] < 0; }),
                  finite.end());
  requireEnough (finite.size(), own_name);
  dropStrays (source.points, finite);
  Eigen::Vector3d low = source.points[finite[0]].cast<double>();
  Eigen::Vector3d high = low;
  for (const int i : finite) {
    low = low.cwiseMin (source.points[i].cast<double>());
    high = high.cwiseMax (source.points[i].cast<double>());
  }
  clouds.center = 0.5 * (low + high);
  clouds.size = (high - low).norm();
  if (!(clouds.size > 0.0))
    throw InvalidInput ("all points of the source are at one place: give a surface");
  requireFineSteps (low.cwiseAbs().cwiseMax (high.cwiseAbs()).maxCoeff(), clouds.size);
  clouds.source = makeWorkingCloud (scaledPoints (clouds, source.points),
                                    source.normals,
                                    finite,
                                    segments,
                                    own_name,
                                    tuning,
                                    threads);
  clouds.target = makeTarget (clouds, target, name, tuning, threads);
  return clouds;
}

PointClouds
withTarget (const PointClouds& clouds,
            const InputPoints& target,
            const std::string& name,
            const Tuning& tuning,
            int threads)
{
  requireNormals (target, name);
  PointClouds other;
  other.source = clouds.source;
  other.source.texture = other.source.thin_texture = {};
  other.center = clouds.center;
  other.size = clouds.size;
  other.target = makeTarget (clouds, target, name, tuning, threads);
  return other;
}

} // namespace pcl_msf
