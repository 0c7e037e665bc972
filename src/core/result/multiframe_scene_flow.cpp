// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/errors.h>
#include <pcl_msf/multiframe_scene_flow.h>

namespace pcl_msf {

bool
MultiframeParameters::isValid (std::string* why) const
{
  std::string problem;
  if (!(concatenation_weight >= 0.0 && concatenation_weight <= 1e9))
    problem = "concatenation_weight must be in [0, 1e9]";
  else if (max_span < 0)
    problem = "max_span must be >= 0";
  if (why && !problem.empty())
    *why = problem;
  return problem.empty();
}

const Report&
MultiframeSceneFlow::report() const
{
  static const Report none{};
  const bool held =
      reference >= 0 && static_cast<std::size_t> (reference) < frames.size();
  return held ? frames[reference].report : none;
}

RigidPose
MultiframeSceneFlow::poseBetween (int from, int to, int segment) const
{
  const int count = static_cast<int> (frames.size());
  if (from < 0 || to < 0 || from >= count || to >= count)
    throw InvalidInput ("poseBetween: the window has no such frame");
  if (motions.empty() || segment < 0 ||
      segment >= static_cast<int> (motions[0].segments.size()))
    throw InvalidInput ("poseBetween: there is no such segment");
  if (from == to)
    return {};
  for (const PairMotion& motion : motions) {
    if (motion.from == from && motion.to == to)
      return motion.segments[segment];
    if (motion.from == to && motion.to == from)
      return motion.segments[segment].inverse();
  }
  return poseBetween (reference, to, segment) * poseBetween (from, reference, segment);
}

} // namespace pcl_msf
