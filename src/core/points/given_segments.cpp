// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/given_segments.h"

#include "core/surface/point_tree.h"
#include <pcl_msf/errors.h>

#include <algorithm>
#include <iterator>
#include <string>

namespace pcl_msf {

namespace {

int
placeOf (const std::vector<int>& ascending, int label)
{
  const auto found = std::lower_bound (ascending.begin(), ascending.end(), label);
  if (found == ascending.end() || *found != label)
    return -1;
  return static_cast<int> (found - ascending.begin());
}

} // namespace

int
GivenSegments::find (int label) const
{
  return placeOf (labels, label);
}

std::vector<int>
closeGaps (std::vector<int>& labels)
{
  std::vector<int> ascending = labels;
  std::sort (ascending.begin(), ascending.end());
  ascending.erase (std::unique (ascending.begin(), ascending.end()), ascending.end());
  for (int& label : labels)
    label = placeOf (ascending, label);
  return ascending;
}

GivenSegments
numberSegments (const std::vector<int>& labels,
                const std::vector<Eigen::Vector3f>& points)
{
  GivenSegments given;
  if (labels.empty())
    return given;
  if (labels.size() != points.size())
    throw InvalidInput ("there are " + std::to_string (labels.size()) + " labels for " +
                        std::to_string (points.size()) +
                        " points: give one per point of the source");
  std::vector<int> born;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (labels[i] >= 0 && points[i].allFinite())
      born.push_back (labels[i]);
  if (born.empty())
    throw InvalidInput ("no finite point of the source is in a segment: give labels or "
                        "clusters of its own, or none");
  given.labels = closeGaps (born);
  given.of.assign (points.size(), -1);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (labels[i] >= 0)
      given.of[i] = given.find (labels[i]);
  return given;
}

std::vector<int>
sampleEach (const std::vector<int>& samples, const std::vector<int>& label, int least)
{
  if (label.empty())
    return samples;
  const int count = 1 + *std::max_element (label.begin(), label.end());
  std::vector<std::vector<int>> points (count);
  for (std::size_t i = 0; i < label.size(); ++i)
    points[label[i]].push_back (static_cast<int> (i));
  std::vector<int> sampled (count, 0);
  for (const int i : samples)
    ++sampled[label[i]];
  std::vector<int> more;
  for (int k = 0; k < count; ++k) {
    const std::size_t step = std::max<std::size_t> (1, points[k].size() / least);
    for (std::size_t i = 0; i < points[k].size() && sampled[k] < least; i += step)
      more.push_back (points[k][i]);
  }
  std::sort (more.begin(), more.end());
  std::vector<int> all;
  std::set_union (samples.begin(),
                  samples.end(),
                  more.begin(),
                  more.end(),
                  std::back_inserter (all));
  return all;
}

std::vector<int>
workingSegments (const PointClouds& clouds,
                 const GivenSegments& given,
                 const std::vector<Eigen::Vector3f>& source)
{
  std::vector<int> working (given.labels.size(), -1);
  const WorkingCloud& cloud = clouds.source;
  for (std::size_t i = 0; i < cloud.segment.size(); ++i)
    working[given.of[cloud.given[i]]] = cloud.segment[i];
  if (std::find (working.begin(), working.end(), -1) == working.end())
    return working;
  const PointTree tree (cloud.surface.points);
  for (std::size_t i = 0; i < source.size(); ++i)
    if (given.of[i] >= 0 && working[given.of[i]] < 0 && source[i].allFinite())
      working[given.of[i]] =
          cloud.segment[tree.nearest (clouds.scaled (source[i])).index];
  return working;
}

} // namespace pcl_msf
