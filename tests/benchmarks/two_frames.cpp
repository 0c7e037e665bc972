// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
//
// Accuracy and time of two-frame scene flow on data folders, beside OpenCV's DIS
// optical flow (medium). Prints a Markdown table.

#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include <pcl_msf/evaluation/flow_errors.h>
#include <pcl_msf/evaluation/residuals.h>
#include <pcl_msf/io/data_folder.h>
#include <pcl_msf/scene_flow_estimator.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <future>
#include <string>
#include <vector>

namespace {

using namespace pcl_msf;

struct Run {
  SceneFlow flow;
  double milliseconds; ///< frames to result, median of the repetitions
};

SceneFlow
estimateOnce (const io::RgbdImages& reference, const io::RgbdImages& current)
{
  FrameParameters target;
  target.normals = NormalMethod::Skip;
  auto later = std::async (std::launch::async, [&] {
    return RgbdFrame::fromImages (current.color, current.depth, current.camera, target);
  });
  const RgbdFrame first =
      RgbdFrame::fromImages (reference.color, reference.depth, reference.camera);
  const RgbdFrame second = later.get();
  return SceneFlowEstimator().estimate (
      first, second, Oversegmentation::fromFrame (first, {}, 0));
}

Run
estimate (const io::RgbdImages& reference,
          const io::RgbdImages& current,
          int repetitions)
{
  Run run;
  std::vector<double> times;
  for (int i = 0; i < repetitions; ++i) {
    const auto start = std::chrono::steady_clock::now();
    run.flow = estimateOnce (reference, current);
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - start;
    times.push_back (spent.count());
  }
  run.milliseconds = evaluation::median (times);
  return run;
}

struct Truth {
  cv::Mat flow;
  cv::Mat scene_flow;
};

cv::Mat
gray (const cv::Mat& color)
{
  cv::Mat result = color;
  if (color.channels() == 3)
    cv::cvtColor (color, result, cv::COLOR_BGR2GRAY);
  return result;
}

/** OpenCV's DIS optical flow, medium preset; empty without colour. */
cv::Mat
disFlow (const io::RgbdImages& reference, const io::RgbdImages& current)
{
  cv::Mat flow;
  if (!reference.color.empty())
    cv::DISOpticalFlow::create (cv::DISOpticalFlow::PRESET_MEDIUM)
        ->calc (gray (reference.color), gray (current.color), flow);
  return flow;
}

/** Photometric residuals divided by another flow's. */
struct Ratios {
  double mean{std::nan ("")};
  double median{std::nan ("")};
};

Ratios
ratios (const cv::Mat& flow,
        const cv::Mat& other,
        const io::RgbdImages& reference,
        const io::RgbdImages& current,
        const cv::Mat& mask)
{
  if (other.empty())
    return {};
  const auto own =
      evaluation::photometricResiduals (flow, reference.color, current.color, mask);
  const auto its =
      evaluation::photometricResiduals (other, reference.color, current.color, mask);
  return {own.mean / its.mean, own.median / its.median};
}

std::string
cell (const char* format, double value)
{
  char text[32] = "-";
  if (value == value)
    std::snprintf (text, sizeof text, format, value);
  return text;
}

void
printRow (const std::string& path, int frame, int repetitions)
{
  const io::DataFolder folder (path);
  const io::RgbdImages reference = folder.frame (0);
  const io::RgbdImages current = folder.frame (frame);
  const Run run = estimate (reference, current, repetitions);
  const cv::Mat dis = disFlow (reference, current);
  const Truth truth{folder.flow (frame), folder.sceneFlow (frame)};
  const cv::Mat all =
      evaluation::scoredPoints (reference.depth, {}, evaluation::ScoredPoints::All);
  const cv::Mat seen = evaluation::scoredPoints (
      reference.depth, folder.visible (frame), evaluation::ScoredPoints::Visible);
  const cv::Mat reported = run.flow.visibility == static_cast<int> (Visible);
  evaluation::FlowErrors own, other;
  evaluation::SceneFlowErrors own3d;
  if (!truth.flow.empty()) {
    own = evaluation::flowErrors (run.flow.flow, truth.flow, seen);
    if (!dis.empty())
      other = evaluation::flowErrors (dis, truth.flow, seen);
  }
  if (!truth.scene_flow.empty())
    own3d = evaluation::sceneFlowErrors (run.flow.displacement, truth.scene_flow, seen);
  const Ratios everywhere = ratios (run.flow.flow, dis, reference, current, all);
  const Ratios there = ratios (run.flow.flow, dis, reference, current, reported);
  const double share = static_cast<double> (cv::countNonZero (
                           run.flow.visibility == static_cast<int> (Visible))) /
                       cv::countNonZero (run.flow.visibility);
  std::printf ("| %s | %zu / %d | %s (%s) | %s | %s | %s | %s | %s | %.2f | %.0f |\n",
               std::filesystem::path (path).filename().c_str(),
               run.flow.segments.size(),
               run.flow.groups,
               cell ("%.3f", own.epe).c_str(),
               cell ("%.3f", own.median).c_str(),
               cell ("%.2f", 1e3 * own3d.epe).c_str(),
               cell ("%.3f", other.epe).c_str(),
               cell ("%.2f", everywhere.mean).c_str(),
               cell ("%.2f", everywhere.median).c_str(),
               cell ("%.2f", there.mean).c_str(),
               share,
               run.milliseconds);
  std::fflush (stdout);
}

} // namespace

int
main (int argc, char** argv)
{
  if (argc < 3 || std::atoi (argv[1]) < 1) {
    std::fprintf (stderr, "Syntax: %s REPETITIONS FOLDER[:FRAME] ...\n", argv[0]);
    return 2;
  }
  std::printf (
      "| case | segments / groups | EPE px, mean (median) | 3D mm | DIS EPE px | "
      "brightness / DIS: mean | median | mean where visible | visible | ms |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n");
  int failures = 0;
  for (int i = 2; i < argc; ++i) {
    std::string path = argv[i];
    int frame = 1;
    if (const auto colon = path.rfind (':'); colon != std::string::npos) {
      frame = std::atoi (path.c_str() + colon + 1);
      path.resize (colon);
    }
    try {
      printRow (path, frame, std::atoi (argv[1]));
    }
    catch (const std::exception& error) {
      std::fprintf (stderr, "%s: %s\n", path.c_str(), error.what());
      ++failures;
    }
  }
  rusage usage{};
  getrusage (RUSAGE_SELF, &usage);
  std::printf ("\nPeak memory %ld MB.\n", usage.ru_maxrss / 1024);
  return failures == 0 ? 0 : 1;
}
