// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "render/inputs.h"

#include "common/interruption.h"
#include "common/option_values.h"
#include "common/tool_main.h"
#include <pcl_msf/errors.h>
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
#include <regex>
#include <tuple>

namespace pcl_msf::tool {

namespace {

namespace fs = std::filesystem;

std::string
sceneFlowName (const ResultPair& pair)
{
  return "scene_flow_" + std::to_string (pair.reference) + "_" +
         std::to_string (pair.current) + ".pcd";
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
requireFrame (const io::RgbdSequence& frames, int frame)
{
  if (frame >= frames.frames())
    throw UsageError (frames.name() + " has " + std::to_string (frames.frames()) +
                      " frames, there is no frame " + std::to_string (frame) +
                      "; choose another by --frame, --reference or --window");
}

/** Last frame that pictures of the way through the window need; 0 = none does. */
int
lastOfWindow (const RenderOptions& options, int current)
{
  const auto& kinds = options.kinds;
  const bool paths =
      options.animation == Animation::Warp ||
      std::find (kinds.begin(),
                 kinds.end(),
                 visualization::PictureKind::Trajectories) != kinds.end();
  if (!paths)
    return 0;
  return options.window > 0 ? options.window : current;
}

/** The pair of a result that is asked for, or else its first. */
ResultPair
choosePair (const std::vector<ResultPair>& pairs, const RenderOptions& options)
{
  for (const ResultPair& pair : pairs)
    if (options.reference.value_or (pair.reference) == pair.reference &&
        options.frame.value_or (pair.current) == pair.current)
      return pair;
  const int reference = options.reference.value_or (pairs.front().reference);
  const int frame = options.frame.value_or (reference + 1);
  throw UsageError (options.input + ": there is no " +
                    sceneFlowName ({reference, frame}) + "; " +
                    sceneFlowName (pairs.front()) +
                    " is, --reference and --frame "
                    "choose");
}

/** Motion groups and visibility, which the cloud does not hold. */
void
addImages (const fs::path& folder, const ResultPair& pair, SceneFlow& flow)
{
  const std::string reference = std::to_string (pair.reference);
  const std::string bodies = (folder / ("bodies_" + reference + ".png")).string();
  if (fs::exists (bodies))
    io::setBodies (io::readLabels (bodies), flow);
  else
    flow.segments.clear();
  const std::string seen = (folder / ("visibility_" + reference + "_" +
                                      std::to_string (pair.current) + ".png"))
                               .string();
  if (!fs::exists (seen))
    return;
  flow.visibility = io::readColor (seen);
  if (flow.visibility.type() != CV_8UC1 || flow.visibility.size() != flow.labels.size())
    throw IoError (seen + ": image: " + std::to_string (flow.visibility.cols) + "x" +
                   std::to_string (flow.visibility.rows) + ", the scene flow " +
                   std::to_string (flow.labels.cols) + "x" +
                   std::to_string (flow.labels.rows) +
                   "; give the folder as pcl_msf_scene_flow wrote it");
}

/** A folder that pcl_msf_scene_flow wrote. */
RenderInputs
loadResult (const ResultPair& pair, const RenderOptions& options)
{
  const fs::path folder = options.input;
  RenderInputs inputs;
  io::StoredSceneFlow stored =
      io::readSceneFlowCloud ((folder / sceneFlowName (pair)).string());
  inputs.result.scene_flow = std::move (stored.scene_flow);
  inputs.result.reference_color = stored.color;
  SceneFlow& flow = inputs.result.scene_flow;
  addImages (folder, pair, flow);
  if (!options.sequence.empty()) {
    const auto frames = openFrames (options.sequence, options.reading);
    requireFrame (*frames, pair.current);
    takeCurrent (frames->frame (pair.current), inputs.result);
  }
  const int window = lastOfWindow (options, pair.current);
  const int last = std::max (window, pair.current);
  for (int k = std::min (pair.reference + 1, pair.current); k <= last; ++k) {
    throwIfInterrupted();
    const std::string path = (folder / sceneFlowName ({pair.reference, k})).string();
    const bool wanted = options.window > 0 || fs::exists (path);
    if (k == pair.current)
      inputs.displacements.push_back (flow.displacement);
    else if (k > pair.reference && k <= window && wanted)
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
  , segments_ (Oversegmentation::fromFrame (reference_, {}, 0))
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

/** Of the frames that matter most, for all. */
double
colorUnit (const io::RgbdImages& reference, const io::RgbdSequence& frames, int frame)
{
  if (reference.raw_color.empty())
    return 1.0;
  const io::RgbdImages current = frames.frame (frame);
  return io::colorUnit ({&reference, &current});
}

/** A folder with frames: the scene flow is computed here. */
RenderInputs
estimate (const RenderOptions& options)
{
  const auto frames = openFrames (options.input, options.reading);
  if (fs::is_directory (fs::path (options.input) / frames->name()))
    throw UsageError (options.input +
                      ": neither scene_flow_R_K.pcd of "
                      "pcl_msf_scene_flow nor frames with camera.txt in it; give its "
                      "folder " +
                      frames->name());
  const int first = options.reference.value_or (0);
  const int current = options.frame.value_or (first + 1);
  const int window = lastOfWindow (options, current);
  const int last = std::max (window, current);
  requireFrame (*frames, std::max (first, last));
  if (current <= first)
    throw UsageError ("--frame: must come after --reference in a folder with frames");
  io::RgbdImages reference = frames->frame (first);
  if (!reference.note.empty())
    complain ("pcl_msf_render",
              "warning: " + options.input + ": frame " + std::to_string (first) + ": " +
                  reference.note);
  const double unit = colorUnit (reference, *frames, current);
  io::setColorUnit (reference, unit);
  const Estimation estimation (reference);
  RenderInputs inputs;
  inputs.result.reference_color = reference.color;
  for (int k = first + 1; k <= last; ++k) {
    if (k != current && k > window)
      continue;
    if (!options.quiet && isatty (STDERR_FILENO) != 0)
      std::fprintf (stderr, "scene flow from frame %d to %d\n", first, k);
    io::RgbdImages images = frames->frame (k);
    io::setColorUnit (images, unit);
    SceneFlow flow = estimation.to (images, [] { return !interrupted(); });
    inputs.displacements.push_back (flow.displacement);
    if (k == current) {
      takeCurrent (images, inputs.result);
      inputs.result.scene_flow = std::move (flow);
    }
  }
  return inputs;
}

} // namespace

std::vector<ResultPair>
resultPairs (const std::string& folder)
{
  static const std::regex name ("scene_flow_([0-9]{1,9})_([0-9]{1,9})\\.pcd");
  std::vector<ResultPair> pairs;
  std::error_code error;
  std::smatch parts;
  for (const auto& entry : fs::directory_iterator (folder, error)) {
    const std::string file = entry.path().filename().string();
    if (std::regex_match (file, parts, name))
      pairs.push_back ({std::stoi (parts[1]), std::stoi (parts[2])});
  }
  // By reference, those after it first.
  std::sort (pairs.begin(), pairs.end(), [] (const ResultPair& a, const ResultPair& b) {
    const bool a_before = a.current < a.reference, b_before = b.current < b.reference;
    return std::tie (a.reference, a_before, a.current) <
           std::tie (b.reference, b_before, b.current);
  });
  return pairs;
}

std::vector<Option>
readingOptions (io::DatasetOptions& options)
{
  return {{"--camera",
           "FX,FY,CX,CY",
           "pinhole camera of the frames, pixels [their own]",
           camera (options.camera)},
          {"--depth-scale",
           "S",
           "units per metre of the frames' 16-bit depth [their own]",
           positive (options.depth_scale)}};
}

std::shared_ptr<const io::RgbdSequence>
openFrames (const std::string& path, const io::DatasetOptions& options)
{
  const auto sequences = io::openDataset ("auto", path, options);
  if (sequences.size() != 1)
    throw UsageError ("'" + path + "': holds " + std::to_string (sequences.size()) +
                      " sequences; give one of their folders");
  return sequences.front();
}

visualization::ResultClouds
estimatePair (io::RgbdImages reference,
              io::RgbdImages current,
              const std::function<bool()>& go_on)
{
  io::unifyColors ({&reference, &current});
  visualization::ResultClouds result;
  result.scene_flow = Estimation (reference).to (current, go_on);
  result.reference_color = reference.color;
  takeCurrent (current, result);
  return result;
}

RenderInputs
loadRenderInputs (const RenderOptions& options)
{
  if (!fs::is_directory (options.input))
    throw IoError (options.input +
                   ": folder: there is none of that name; check the path");
  const std::vector<ResultPair> pairs = resultPairs (options.input);
  return pairs.empty() ? estimate (options)
                       : loadResult (choosePair (pairs, options), options);
}

} // namespace pcl_msf::tool
