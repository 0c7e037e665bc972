// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/default_estimation.h"

#include "common/command_line.h"
#include "common/depth_points.h"
#include "common/interruption.h"
#include <pcl_msf/scene_flow_estimator.h>

namespace pcl_msf::tool {

DefaultEstimation::DefaultEstimation (const io::RgbdImages& reference)
: reference_ (
      RgbdFrame::fromImages (reference.color, reference.depth, reference.camera))
, segments_ (Oversegmentation::fromFrame (reference_, {}, 0))
{}

SceneFlow
DefaultEstimation::to (const io::RgbdImages& images,
                       const std::function<bool()>& go_on) const
{
  FrameParameters target;
  target.normals = NormalMethod::Skip;
  SolverParameters solver;
  solver.progress = [&go_on] (const Progress&) { return go_on(); };
  const SceneFlow flow =
      SceneFlowEstimator (EnergyParameters(), solver)
          .estimate (
              reference_,
              RgbdFrame::fromImages (images.color, images.depth, images.camera, target),
              segments_);
  if (!go_on())
    throw Interrupted();
  return flow;
}

void
takeCurrent (const io::RgbdImages& current, visualization::ResultClouds& result)
{
  const cv::Size size = result.scene_flow.labels.size(), given = current.depth.size();
  if (given != size)
    throw UsageError ("--sequence: its frames are " + std::to_string (given.width) +
                      "x" + std::to_string (given.height) + ", the result is " +
                      std::to_string (size.width) + "x" + std::to_string (size.height) +
                      "; give the frames that it was made of");
  result.current_points = pointsOf (current);
  result.current_color = current.color;
}

visualization::ResultClouds
estimatePair (io::RgbdImages reference,
              io::RgbdImages current,
              const std::function<bool()>& go_on)
{
  io::unifyColors ({&reference, &current});
  visualization::ResultClouds result;
  result.scene_flow = DefaultEstimation (reference).to (current, go_on);
  result.reference_color = reference.color;
  takeCurrent (current, result);
  return result;
}

} // namespace pcl_msf::tool
