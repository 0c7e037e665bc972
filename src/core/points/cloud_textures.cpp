// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/cloud_textures.h"

#include <pcl_msf/errors.h>

#include <algorithm>
#include <string>

namespace pcl_msf {

namespace {

void
requireSize (const std::vector<float>& brightness, std::size_t size, const char* name)
{
  if (brightness.size() != size)
    throw InvalidInput ("the " + std::string (name) + " has " + std::to_string (size) +
                        " points and " + std::to_string (brightness.size()) +
                        " values of brightness: give one per point of both clouds, "
                        "NaN where it is unknown, or none for both");
}

/** \param values per point as given */
void
addTextures (const std::vector<float>& values,
             double radius,
             double thin_radius,
             const PointBrightnessTuning& tuning,
             int threads,
             WorkingCloud& cloud)
{
  std::vector<float> working;
  for (const int i : cloud.given)
    working.push_back (values[i]);
  cloud.texture =
      fitTexture (cloud.surface, working, radius, tuning.neighbors, threads);
  cloud.thin_texture =
      fitTexture (cloud.thin,
                  meanBrightness (cloud.surface, working, cloud.samples, threads),
                  thin_radius,
                  tuning.neighbors,
                  threads);
}

/** What varies by noise alone in one cloud tells nothing of the other. */
void
shareTrust (double least, SurfaceTexture& first, SurfaceTexture& second)
{
  first.trust = second.trust = std::min (first.trust, second.trust);
  if (!(first.trust >= least))
    first.slope = second.slope = 0.0;
}

} // namespace

void
addTextures (const CloudBrightness& brightness,
             std::size_t source_size,
             std::size_t target_size,
             const PointBrightnessTuning& tuning,
             int threads,
             PointClouds& clouds)
{
  if (brightness.empty())
    return;
  requireSize (brightness.source, source_size, "source");
  requireSize (brightness.target, target_size, "target");
  WorkingCloud& source = clouds.source;
  WorkingCloud& target = clouds.target;
  const double radius = tuning.radius * std::max (source.surface.median_spacing,
                                                  target.surface.median_spacing);
  const double thin_radius =
      tuning.radius * std::max (source.thin.median_spacing, target.thin.median_spacing);
  addTextures (brightness.source, radius, thin_radius, tuning, threads, source);
  addTextures (brightness.target, radius, thin_radius, tuning, threads, target);
  shareTrust (tuning.least_trust, source.texture, target.texture);
  shareTrust (tuning.least_trust, source.thin_texture, target.thin_texture);
}

void
dropTextures (PointClouds& clouds)
{
  for (WorkingCloud* cloud : {&clouds.source, &clouds.target})
    cloud->texture = cloud->thin_texture = {};
}

} // namespace pcl_msf
