// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "own_method.h"

#include "common/option_values.h"
#include "common/stop_watch.h"
#include "lifting.h"
#include <pcl_msf/evaluation/motion_errors.h>
#include <pcl_msf/scene_flow_estimator.h>

#include <future>
#include <sstream>

namespace pcl_msf::tool {

namespace {

/** Every combination of a segment and a true body becomes a segment. */
cv::Mat
cutAlong (const cv::Mat& segments, const cv::Mat& bodies)
{
  double most = 0.0;
  cv::minMaxLoc (bodies, nullptr, &most);
  const int count = static_cast<int> (most) + 2; // one more for "none"
  cv::Mat result = segments.clone();
  for (int y = 0; y < result.rows; ++y)
    for (int x = 0; x < result.cols; ++x) {
      int& label = result.at<int> (y, x);
      if (label >= 0)
        label = label * count + std::max (-1, bodies.at<int> (y, x)) + 1;
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

} // namespace

OwnMethod::OwnMethod (const std::string& settings, unsigned threads)
{
  std::istringstream stream (settings);
  for (std::string setting; std::getline (stream, setting, ':');)
    apply (setting);
  options_.solver.threads = threads;
  requireValid (options_.frame, settings);
  requireValid (options_.segmentation, settings);
  requireValid (options_.energy, settings);
  requireValid (options_.solver, settings);
}

void
OwnMethod::apply (const std::string& setting)
{
  const std::size_t at = std::min (setting.find ('='), setting.size());
  const std::string key = setting.substr (0, at);
  const std::string value = setting.substr (std::min (at + 1, setting.size()));
  bool taken = false;
  if (key == "labels")
    taken = choice<LabelSource> (labels_,
                                 {{"method", LabelSource::Method},
                                  {"true", LabelSource::Truth},
                                  {"cut", LabelSource::Cut}}) (value);
  else if (key == "start")
    taken = choice<StartSource> (
        start_,
        {{"method", StartSource::Method}, {"true", StartSource::Truth}}) (value);
  else {
    const Option* found = nullptr;
    const std::vector<OptionGroup> table = methodOptions (options_);
    for (const OptionGroup& group : table)
      for (const Option& option : group.options)
        if (option.name == "--" + key)
          found = &option;
    if (found == nullptr)
      throw UsageError ("--methods: msf has no setting '" + key +
                        "'; labels, start, or an option of pcl_msf_scene_flow");
    taken = found->set (value);
  }
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
      frame, options_.segmentation, options_.solver.threads);
  if (labels_ == LabelSource::Method)
    return own;
  return Oversegmentation::fromLabels (cutAlong (own.labels(), pair.truth.labels),
                                       frame);
}

SceneFlow
OwnMethod::estimate (const PairData& pair,
                     const RgbdFrame& reference,
                     const RgbdFrame& current,
                     const Oversegmentation& segments) const
{
  const SceneFlowEstimator estimator (options_.energy, options_.solver);
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
  FrameParameters target = options_.frame;
  target.normals = NormalMethod::Skip;
  StopWatch total, watch;
  const auto policy =
      options_.solver.threads == 1 ? std::launch::deferred : std::launch::async;
  auto later =
      std::async (policy, [&] { return makeFrame (pair.current, target, color); });
  const RgbdFrame reference = makeFrame (pair.reference, options_.frame, color);
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
  result.visible = flow.visibility == static_cast<int> (Visible);
  result.dominant = flow.dominant_motion;
  return result;
}

} // namespace pcl_msf::tool
