// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/methods/own_method.h"

#include "common/depth_points.h"
#include "common/stop_watch.h"
#include <CLI/App.hpp>
#include <pcl_msf/evaluation/motion_errors.h>
#include <pcl_msf/scene_flow_estimator.h>

#include <future>
#include <sstream>

namespace pcl_msf::tool {

namespace {

/** Every combination of a segment and a true body becomes a segment.
 * \param level of the segments; the bodies are of the input */
cv::Mat
cutAlong (const cv::Mat& segments, const cv::Mat& bodies, int level)
{
  double most = 0.0;
  cv::minMaxLoc (bodies, nullptr, &most);
  const int count = static_cast<int> (most) + 2; // one more for "none"
  cv::Mat result = segments.clone();
  for (int y = 0; y < result.rows; ++y)
    for (int x = 0; x < result.cols; ++x) {
      int& label = result.at<int> (y, x);
      if (label >= 0)
        label =
            label * count + std::max (-1, bodies.at<int> (y << level, x << level)) + 1;
    }
  return result;
}

RgbdFrame
makeFrame (const io::RgbdImages& images, const FrameParameters& parameters, bool color)
{
  return RgbdFrame::fromImages (
      color ? images.color : cv::Mat(), images.depth, images.camera, parameters);
}

template <typename Parameters>
void
requireValid (const Parameters& parameters, const std::string& settings)
{
  std::string why;
  if (!parameters.isValid (&why))
    throw UsageError ("--methods: msf:" + settings + ": " + why);
}

/** One option of the method; false when it has no such value. */
bool
set (MethodSettings& settings, const std::string& key, const std::string& value)
{
  CLI::App app;
  addMethodOptions (app, settings);
  if (app.get_option_no_throw ("--" + key) == nullptr)
    throw UsageError ("--methods: msf has no setting '" + key +
                      "'; labels, start, or an option of pcl_msf_scene_flow for two "
                      "frames");
  try {
    return readCommandLine (app, {"--" + key + "=" + value});
  }
  catch (const UsageError&) {
    return false;
  }
}

} // namespace

OwnMethod::OwnMethod (const std::string& settings, unsigned threads)
{
  std::istringstream stream (settings);
  for (std::string setting; std::getline (stream, setting, ':');)
    apply (setting);
  settings_.solver.threads = threads;
  requireValid (settings_.frame, settings);
  requireValid (settings_.segmentation, settings);
  requireValid (settings_.energy, settings);
  requireValid (settings_.solver, settings);
  if (start_ == StartSource::Truth && settings_.frame.finest_level > 0)
    throw UsageError ("--methods: msf:" + settings +
                      ": the true start is told pixel by pixel; give finest-level=0");
}

void
OwnMethod::apply (const std::string& setting)
{
  const std::size_t at = std::min (setting.find ('='), setting.size());
  const std::string key = setting.substr (0, at);
  const std::string value = setting.substr (std::min (at + 1, setting.size()));
  bool taken = true;
  if (key == "labels")
    taken = choose<LabelSource> (value,
                                 {{"method", LabelSource::Method},
                                  {"true", LabelSource::Truth},
                                  {"cut", LabelSource::Cut}},
                                 labels_);
  else if (key == "start")
    taken = choose<StartSource> (
        value, {{"method", StartSource::Method}, {"true", StartSource::Truth}}, start_);
  else
    taken = set (settings_, key, value);
  if (!taken)
    throw UsageError ("--methods: '" + value + "' is no value of " + key +
                      "; see this option in pcl_msf_scene_flow --help");
}

bool
OwnMethod::canRun (const PairData& pair) const
{
  return (labels_ == LabelSource::Method || !pair.truth.labels.empty()) &&
         (start_ == StartSource::Method || !pair.truth.scene_flow.empty());
}

Oversegmentation
OwnMethod::segment (const PairData& pair, const RgbdFrame& frame) const
{
  if (labels_ == LabelSource::Truth)
    return Oversegmentation::fromLabels (pair.truth.labels, frame);
  const Oversegmentation own = Oversegmentation::fromFrame (
      frame, settings_.segmentation, settings_.solver.threads);
  if (labels_ == LabelSource::Method)
    return own;
  return Oversegmentation::fromLabels (
      cutAlong (own.labels(), pair.truth.labels, frame.finestLevel()), frame);
}

SceneFlow
OwnMethod::estimate (const PairData& pair,
                     const RgbdFrame& reference,
                     const RgbdFrame& current,
                     const Oversegmentation& segments) const
{
  const SceneFlowEstimator estimator (settings_.energy, settings_.solver);
  if (start_ == StartSource::Method)
    return estimator.estimate (reference, current, segments);
  return estimator.estimateFrom (reference,
                                 current,
                                 segments,
                                 evaluation::fitSegments (segments.labels(),
                                                          pointsOf (pair.reference),
                                                          pair.truth.scene_flow,
                                                          segments.size()));
}

Estimate
OwnMethod::run (const PairData& pair) const
{
  const bool color = !pair.reference.color.empty() && !pair.current.color.empty();
  FrameParameters target = settings_.frame;
  target.normals = NormalMethod::Skip;
  StopWatch total, watch;
  const auto policy =
      settings_.solver.threads == 1 ? std::launch::deferred : std::launch::async;
  auto later =
      std::async (policy, [&] { return makeFrame (pair.current, target, color); });
  const RgbdFrame reference = makeFrame (pair.reference, settings_.frame, color);
  const RgbdFrame current = later.get();
  Estimate result;
  result.seconds.frame = watch.lap();
  const Oversegmentation segments = segment (pair, reference);
  result.seconds.segment = watch.lap();
  result.scene_flow = estimate (pair, reference, current, segments);
  const SceneFlow& flow = *result.scene_flow;
  result.seconds.total = total.lap();
  result.seconds.start = flow.report.start_seconds;
  result.seconds.solve = flow.report.solve_seconds;
  result.seconds.result = flow.report.result_seconds;
  result.flow = flow.flow;
  result.displacement = flow.displacement;
  result.visible = flow.visibility == pixelValue (Visibility::Visible);
  result.dominant = flow.dominant_motion;
  return result;
}

} // namespace pcl_msf::tool
