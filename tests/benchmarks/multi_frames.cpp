// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
//
// Accuracy and processor time of windows of frames on data folders: frame 0 to the
// last, jointly, beside the direct two-frame solve and the concatenation of
// frame-to-frame solves. Without true flow the errors are brightness residuals in grey
// levels.

#include <pcl_msf/evaluation/flow_errors.h>
#include <pcl_msf/evaluation/residuals.h>
#include <pcl_msf/io/data_folder.h>
#include <pcl_msf/multiframe_estimator.h>
#include <pcl_msf/scene_flow_estimator.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using namespace pcl_msf;
/** Processor time, which other programs on the machine change less than the clock. */
struct Clock {
  static double
  now ()
  {
    rusage usage{};
    getrusage (RUSAGE_SELF, &usage);
    return 1e3 * static_cast<double> (usage.ru_utime.tv_sec) +
           1e-3 * static_cast<double> (usage.ru_utime.tv_usec);
  }
};

double
millisecondsSince (double start)
{
  return Clock::now() - start;
}

RgbdFrame
makeFrame (const io::RgbdImages& images)
{
  return RgbdFrame::fromImages (images.color, images.depth, images.camera);
}

/** Frame-to-frame scene flows, each with segments of its own, walked point by point.
 * Where a step is unknown the point goes on as in the step before. */
SceneFlow
concatenate (const std::vector<RgbdFrame>& frames)
{
  SceneFlow total;
  std::vector<SceneFlow> steps;
  for (std::size_t k = 0; k + 1 < frames.size(); ++k)
    steps.push_back (SceneFlowEstimator().estimate (
        frames[k], frames[k + 1], Oversegmentation::fromFrame (frames[k], {}, 0)));
  total = steps[0];
  const PinholeCamera& camera = total.camera;
  const cv::Size size = total.flow.size();
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const cv::Vec3f start = total.points.at<cv::Vec3f> (y, x);
      cv::Vec3f step = total.displacement.at<cv::Vec3f> (y, x);
      cv::Vec3f at = start + step;
      for (std::size_t k = 1; k < steps.size(); ++k) {
        const Eigen::Vector2d uv = camera.project ({at[0], at[1], at[2]});
        const int u = cvRound (uv.x());
        const int v = cvRound (uv.y());
        if (u >= 0 && v >= 0 && u < size.width && v < size.height) {
          const cv::Vec3f next = steps[k].displacement.at<cv::Vec3f> (v, u);
          if (std::isfinite (next[0]))
            step = next;
        }
        at += step;
      }
      const Eigen::Vector2d uv = camera.project ({at[0], at[1], at[2]});
      total.displacement.at<cv::Vec3f> (y, x) = at - start;
      total.flow.at<cv::Vec2f> (y, x) = {static_cast<float> (uv.x()) - x,
                                         static_cast<float> (uv.y()) - y};
    }
  return total;
}

/** Pixels where there is truth, grey levels where there is none. */
struct Errors {
  double mean{std::nan ("")};
  double median{std::nan ("")};
};

struct Score {
  Errors pixels;
  double millimetres{std::nan ("")};
};

Score
scoreOf (const SceneFlow& flow, const io::DataFolder& folder, int last)
{
  const io::RgbdImages first = folder.frame (0);
  const cv::Mat mask = evaluation::scoredPoints (
      first.depth, folder.visible (last), evaluation::ScoredPoints::Visible);
  Score score;
  if (const cv::Mat truth = folder.flow (last); !truth.empty()) {
    const evaluation::FlowErrors errors =
        evaluation::flowErrors (flow.flow, truth, mask);
    score.pixels = {errors.epe, errors.median};
  }
  else if (!first.color.empty()) {
    const evaluation::PhotometricResiduals residuals =
        evaluation::photometricResiduals (
            flow.flow, first.color, folder.frame (last).color, first.depth > 0.0);
    score.pixels = {residuals.mean, residuals.median};
  }
  if (const cv::Mat truth = folder.sceneFlow (last); !truth.empty())
    score.millimetres =
        1e3 * evaluation::sceneFlowErrors (flow.displacement, truth, mask).epe;
  return score;
}

void
printRow (const std::string& path, int count, const MultiframeParameters& parameters)
{
  const io::DataFolder folder (path);
  const int last = count - 1;
  std::vector<io::RgbdImages> images;
  for (int k = 0; k < count; ++k)
    images.push_back (folder.frame (k));
  auto start = Clock::now();
  std::vector<RgbdFrame> frames;
  for (const io::RgbdImages& image : images)
    frames.push_back (makeFrame (image));
  const double prepare = millisecondsSince (start);
  start = Clock::now();
  const Oversegmentation segments = Oversegmentation::fromFrame (frames[0], {}, 0);
  const double cut = millisecondsSince (start);
  start = Clock::now();
  const SceneFlow direct =
      SceneFlowEstimator().estimate (frames[0], frames[last], segments);
  const double two = cut + 2.0 * prepare / count + millisecondsSince (start);
  const SceneFlow chain = concatenate (frames);
  start = Clock::now();
  const MultiframeEstimator estimator ({}, {}, parameters);
  const MultiframeSceneFlow window = estimator.estimate (frames, 0, segments);
  const double joint = cut + prepare + millisecondsSince (start);
  const Score a = scoreOf (chain, folder, last);
  const Score b = scoreOf (direct, folder, last);
  const Score c = scoreOf (window.frames[last], folder, last);
  std::printf ("| %s | %d | %d | %.3f (%.3f) %.2f | %.3f (%.3f) %.2f | %.3f (%.3f) "
               "%.2f | %.2f | %.0f | %.0f | %.1f |\n",
               std::filesystem::path (path).filename().c_str(),
               count,
               window.frames[last].groups,
               a.pixels.mean,
               a.pixels.median,
               a.millimetres,
               b.pixels.mean,
               b.pixels.median,
               b.millimetres,
               c.pixels.mean,
               c.pixels.median,
               c.millimetres,
               c.pixels.mean / std::min (a.pixels.mean, b.pixels.mean),
               two,
               joint,
               joint / two);
  std::fflush (stdout);
}

/** Long windows use adjacent pairs and those with the reference only. */
MultiframeParameters
parametersFor (int frames)
{
  constexpr int kLongWindow = 8;
  MultiframeParameters parameters;
  parameters.max_span = frames > kLongWindow ? 1 : 0;
  return parameters;
}

} // namespace

int
main (int argc, char** argv)
{
  if (argc < 3) {
    std::fprintf (stderr, "Syntax: %s FRAMES FOLDER ...\n", argv[0]);
    return 2;
  }
  const int frames = std::atoi (argv[1]);
  const MultiframeParameters parameters = parametersFor (frames);
  std::printf ("| case | frames | groups | frame to frame, EPE px, mean (median) 3D mm "
               "| direct | jointly | joint / best | two-frame ms | joint ms | ratio |\n"
               "|---|---|---|---|---|---|---|---|---|---|\n");
  int failures = 0;
  for (int i = 2; i < argc; ++i)
    try {
      printRow (argv[i], frames, parameters);
    }
    catch (const std::exception& error) {
      std::fprintf (stderr, "%s: %s\n", argv[i], error.what());
      ++failures;
    }
  return failures == 0 ? 0 : 1;
}
