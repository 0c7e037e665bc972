// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "render/inputs.h"

#include "common/command_line.h"
#include "common/interruption.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/data_folder.h>
#include <pcl_msf/io/images.h>
#include <pcl_msf/io/result_files.h>
#include <pcl_msf/oversegmentation.h>
#include <pcl_msf/rgbd_frame.h>
#include <pcl_msf/scene_flow_estimator.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>

namespace pcl_msf::tool {

namespace {

namespace fs = std::filesystem;

std::string
numbered (const fs::path& folder, const char* name, int frame, const char* extension)
{
  return (folder / (name + std::to_string (frame) + extension)).string();
}

/** Points of a depth image. */
cv::Mat
backProject (const io::RgbdImages& images)
{
  cv::Mat points (images.depth.size(),
                  CV_32FC3,
                  cv::Scalar::all (std::numeric_limits<float>::quiet_NaN()));
  for (int row = 0; row < points.rows; ++row)
    for (int col = 0; col < points.cols; ++col) {
      const float z = images.depth.at<float> (row, col);
      if (!(z > 0.0F) || !std::isfinite (z))
        continue;
      const Eigen::Vector3f p = images.camera.backProject (col, row, z).cast<float>();
      points.at<cv::Vec3f> (row, col) = {p.x(), p.y(), p.z()};
    }
  return points;
}

void
takeCurrent (const io::RgbdImages& current, visualization::ResultClouds& result)
{
  result.current_points = backProject (current);
  result.current_color = current.color;
}

void
requireFrame (const io::DataFolder& folder, int frame)
{
  if (frame >= folder.frames())
    throw UsageError (folder.path() + " has " + std::to_string (folder.frames()) +
                      " frames, there is no frame " + std::to_string (frame));
}

/** Last frame that pictures of the way through the window need; 0 = none does. */
int
lastOfWindow (const RenderOptions& options)
{
  const auto& kinds = options.kinds;
  const bool paths =
      options.animation == Animation::Warp ||
      std::find (kinds.begin(),
                 kinds.end(),
                 visualization::PictureKind::Trajectories) != kinds.end();
  if (!paths)
    return 0;
  return options.window > 0 ? options.window : options.frame;
}

/** A folder that pcl_msf_scene_flow wrote. */
RenderInputs
loadResult (const RenderOptions& options)
{
  const fs::path folder = options.input;
  RenderInputs inputs;
  io::StoredSceneFlow stored = io::readSceneFlowCloud (
      numbered (folder, "scene_flow_0_", options.frame, ".pcd"));
  inputs.result.scene_flow = std::move (stored.scene_flow);
  inputs.result.reference_color = stored.color;
  SceneFlow& flow = inputs.result.scene_flow;
  const std::string bodies = (folder / "bodies_0.png").string();
  if (fs::exists (bodies))
    io::setBodies (io::readLabels (bodies), flow);
  else
    flow.segments.clear();
  const std::string seen = numbered (folder, "visibility_0_", options.frame, ".png");
  if (fs::exists (seen)) {
    flow.visibility = io::readColor (seen);
    if (flow.visibility.type() != CV_8UC1 ||
        flow.visibility.size() != flow.labels.size())
      throw IoError (seen + ": image: not of the scene flow's size");
  }
  if (!options.sequence.empty()) {
    const io::DataFolder frames (options.sequence);
    requireFrame (frames, options.frame);
    takeCurrent (frames.frame (options.frame), inputs.result);
  }
  const int last = std::max (lastOfWindow (options), options.frame);
  for (int k = 1; k <= last; ++k) {
    throwIfInterrupted();
    const std::string path = numbered (folder, "scene_flow_0_", k, ".pcd");
    const bool wanted = options.window > 0 || fs::exists (path);
    if (k == options.frame)
      inputs.displacements.push_back (flow.displacement);
    else if (k <= lastOfWindow (options) && wanted)
      inputs.displacements.push_back (
          io::readSceneFlowCloud (path).scene_flow.displacement);
  }
  return inputs;
}

/** The method with its default parameters. */
class Estimation {
public:
  explicit Estimation (const io::RgbdImages& reference)
  : reference_ (
        RgbdFrame::fromImages (reference.color, reference.depth, reference.camera))
  , segments_ (Oversegmentation::fromFrame (reference_))
  {}

  SceneFlow
  to (const io::RgbdImages& images, const std::function<bool()>& go_on) const
  {
    FrameParameters target;
    target.normals = NormalMethod::Skip;
    SolverParameters solver;
    solver.progress = [&go_on] (const Progress&) { return go_on(); };
    const SceneFlow flow =
        SceneFlowEstimator (EnergyParameters(), solver)
            .estimate (reference_,
                       RgbdFrame::fromImages (
                           images.color, images.depth, images.camera, target),
                       segments_);
    if (!go_on())
      throw Interrupted();
    return flow;
  }

private:
  RgbdFrame reference_;
  Oversegmentation segments_;
};

/** A folder with frames: the scene flow is computed here. */
RenderInputs
estimate (const RenderOptions& options)
{
  const io::DataFolder folder (options.input);
  const int last = std::max (lastOfWindow (options), options.frame);
  requireFrame (folder, last);
  io::RgbdImages reference = folder.frame (0);
  const Estimation estimation (reference);
  RenderInputs inputs;
  inputs.result.reference_color = reference.color;
  for (int k = 1; k <= last; ++k) {
    if (k != options.frame && k > lastOfWindow (options))
      continue;
    if (!options.quiet && isatty (STDERR_FILENO) != 0)
      std::fprintf (stderr, "scene flow from frame 0 to %d\n", k);
    const io::RgbdImages images = folder.frame (k);
    SceneFlow flow = estimation.to (images, [] { return !interrupted(); });
    inputs.displacements.push_back (flow.displacement);
    if (k == options.frame) {
      takeCurrent (images, inputs.result);
      inputs.result.scene_flow = std::move (flow);
    }
  }
  return inputs;
}

} // namespace

visualization::ResultClouds
estimatePair (const io::RgbdImages& reference,
              const io::RgbdImages& current,
              const std::function<bool()>& go_on)
{
  visualization::ResultClouds result;
  result.scene_flow = Estimation (reference).to (current, go_on);
  result.reference_color = reference.color;
  takeCurrent (current, result);
  return result;
}

RenderInputs
loadRenderInputs (const RenderOptions& options)
{
  const std::string result =
      numbered (options.input, "scene_flow_0_", options.frame, ".pcd");
  if (fs::exists (result))
    return loadResult (options);
  if (!fs::is_directory (options.input))
    throw IoError (options.input + ": folder: there is none of that name");
  if (!fs::exists (fs::path (options.input) / "camera.txt") &&
      !fs::exists (fs::path (options.input) / "cloud_0.pcd"))
    throw IoError (options.input + ": neither scene_flow_0_" +
                   std::to_string (options.frame) +
                   ".pcd of pcl_msf_scene_flow nor frames with camera.txt in it");
  return estimate (options);
}

} // namespace pcl_msf::tool
