// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/cloud_window.h"
#include <pcl_msf/cloud_flow_estimator.h>
#include <pcl_msf/errors.h>

#include <string>
#include <utility>

namespace pcl_msf {

namespace {

void
requireReference (std::size_t frames, int reference)
{
  if (frames < 2)
    throw InvalidInput ("a window has two clouds or more: there are " +
                        std::to_string (frames));
  if (reference < 0 || static_cast<std::size_t> (reference) >= frames)
    throw InvalidInput ("the reference is none of the " + std::to_string (frames) +
                        " clouds: give its index, from 0");
}

void
requireFinite (const RigidPose& start)
{
  if (!start.isFinite())
    throw InvalidInput ("the start is not finite: give a rotation in radians and a "
                        "translation in the points' unit, or none");
}

/** A frame's name in messages: targets by their number, from 1, when there are several.
 */
std::string
nameOf (int frame, int reference, std::size_t frames)
{
  if (frame == reference)
    return "source";
  const int number = frame < reference ? frame + 1 : frame;
  return frames > 2 ? "target " + std::to_string (number) : "target";
}

/** Also of frames whose brightness has nothing to be compared with. */
void
requireBrightness (const std::vector<CloudFrame>& frames, int reference)
{
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const std::size_t points = frames[f].points.size();
    const std::size_t values = frames[f].brightness.size();
    if (values != 0 && values != points)
      throw InvalidInput (
          "the " + nameOf (static_cast<int> (f), reference, frames.size()) + " has " +
          std::to_string (points) + " points and " + std::to_string (values) +
          " values of brightness: give one per point, NaN where it is "
          "unknown, or none");
  }
}

/** The report of all targets: the first one's that was not found, if any. */
Report
windowReport (const std::vector<CloudFlow>& flows)
{
  for (const CloudFlow& flow : flows)
    if (!flow.report.converged)
      return flow.report;
  return flows.front().report;
}

} // namespace

CloudFlowEstimator::CloudFlowEstimator (SolverParameters solver,
                                        CloudConstraints constraints,
                                        MultiframeParameters multiframe)
: solver_ (std::move (solver))
, constraints_ (std::move (constraints))
, multiframe_ (multiframe)
{
  std::string why;
  if (!solver_.isValid (&why) || !constraints_.isValid (&why) ||
      !multiframe_.isValid (&why))
    throw InvalidInput (why);
}

CloudFlow
CloudFlowEstimator::estimate (const std::vector<Eigen::Vector3f>& source,
                              const std::vector<Eigen::Vector3f>& target,
                              const RigidPose& start,
                              const std::vector<int>& segments,
                              const CloudBrightness& brightness) const
{
  requireFinite (start);
  const GivenClouds given{
      source, {{target, &brightness, "target"}}, 0, segments, brightness.weight};
  CloudWindow window (given, solver_, constraints_);
  return std::move (window.run (start, 0.0).front());
}

std::vector<CloudFlow>
CloudFlowEstimator::estimateWindow (const std::vector<CloudFrame>& frames,
                                    int reference,
                                    const RigidPose& start,
                                    const std::vector<int>& segments,
                                    double brightness_weight) const
{
  requireReference (frames.size(), reference);
  requireFinite (start);
  if (brightness_weight != 0.0)
    requireBrightness (frames, reference);
  const CloudFrame& source = frames[reference];
  std::vector<CloudBrightness> brightness (frames.size());
  GivenClouds given{
      {source.points, source.normals}, {}, reference, segments, brightness_weight};
  for (int f = 0; f < static_cast<int> (frames.size()); ++f) {
    if (f == reference)
      continue;
    if (!source.brightness.empty() && !frames[f].brightness.empty())
      brightness[f] = {source.brightness, frames[f].brightness, brightness_weight};
    given.targets.push_back ({{frames[f].points, frames[f].normals},
                              &brightness[f],
                              nameOf (f, reference, frames.size())});
  }
  CloudWindow window (given, solver_, constraints_);
  std::vector<CloudFlow> flows = window.run (start, multiframe_.concatenation_weight);
  CloudFlow own;
  own.report = windowReport (flows);
  flows.insert (flows.begin() + reference, std::move (own));
  return flows;
}

} // namespace pcl_msf
