// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/sample_cuts.h"

#include "core/surface/point_tree.h"

#include <algorithm>
#include <utility>

namespace pcl_msf {

namespace {

std::vector<SampleCut>
cutCoarsely (const WorkingCloud& cloud, const Tuning& tuning)
{
  std::vector<SampleCut> cuts;
  for (std::size_t s = 0; s + 1 < tuning.points.stages.size(); ++s) {
    SampleCut cut;
    cut.segments = cutSurface (cloud.thin,
                               tuning.points.stages[s].segments,
                               cuts.empty() ? std::vector<int>() : cuts.back().seeds,
                               tuning.surface);
    cut.seeds = cut.segments.seeds;
    cut.label = cut.segments.label;
    cut.members = cut.segments.members;
    cuts.push_back (std::move (cut));
  }
  return cuts;
}

void
seeBySamples (const WorkingCloud& cloud, SampleCut& cut)
{
  for (const int sample : cloud.samples) {
    cut.label.push_back (cut.segments.label[sample]);
    cut.members.push_back (cut.segments.members[sample]);
  }
}

SampleCut
cutFinely (const WorkingCloud& cloud,
           const std::vector<int>& coarse_seeds,
           const Tuning& tuning)
{
  std::vector<int> seeds;
  for (const int seed : coarse_seeds)
    seeds.push_back (cloud.samples[seed]);
  SampleCut cut;
  cut.segments = cutSurface (
      cloud.surface, tuning.points.stages.back().segments, seeds, tuning.surface);
  const PointTree tree (cloud.thin.points);
  for (const int seed : cut.segments.seeds)
    cut.seeds.push_back (tree.nearest (cloud.surface.points[seed]).index);
  seeBySamples (cloud, cut);
  return cut;
}

SampleCut
takeGiven (const WorkingCloud& cloud, const std::vector<char>& fixed)
{
  const int count = 1 + *std::max_element (cloud.segment.begin(), cloud.segment.end());
  SampleCut cut;
  cut.segments = takeSegments (cloud.surface, cloud.segment, count);
  cut.segments.fixed = fixed;
  seeBySamples (cloud, cut);
  cut.seeds.assign (count, -1);
  for (std::size_t s = cloud.samples.size(); s-- > 0;)
    cut.seeds[cut.label[s]] = static_cast<int> (s);
  return cut;
}

} // namespace

std::vector<SampleCut>
cutSamples (const WorkingCloud& cloud,
            const std::vector<char>& fixed,
            const Tuning& tuning)
{
  if (!cloud.segment.empty())
    return std::vector<SampleCut> (tuning.points.stages.size(),
                                   takeGiven (cloud, fixed));
  std::vector<SampleCut> cuts = cutCoarsely (cloud, tuning);
  cuts.push_back (cutFinely (cloud, cuts.back().seeds, tuning));
  return cuts;
}

} // namespace pcl_msf
