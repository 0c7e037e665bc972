// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
//
// Accuracy and time of two-frame scene flow on data folders, beside OpenCV's DIS
// optical flow (medium). Prints a Markdown table.

#include "scores.h"
#include <pcl_msf/io/data_folder.h>
#include <pcl_msf/scene_flow_estimator.h>
#include <sys/resource.h>

#include <chrono>
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
  target.normals = NormalMethod::None;
  auto later = std::async (std::launch::async, [&] {
    return RgbdFrame::fromImages (current.color, current.depth, current.camera, target);
  });
  const RgbdFrame first =
      RgbdFrame::fromImages (reference.color, reference.depth, reference.camera);
  const RgbdFrame second = later.get();
  return SceneFlowEstimator().estimate (
      first, second, Oversegmentation::fromFrame (first));
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
  run.milliseconds = benchmark::median (times);
  return run;
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
  const cv::Mat dis = benchmark::disFlow (reference, current);
  const cv::Mat truth = folder.flow (frame);
  const cv::Mat truth3d = folder.sceneFlow (frame);
  const cv::Mat visible = folder.visible (frame);
  const double nan = std::nan ("");
  benchmark::Errors own{nan, nan}, other{nan, nan};
  benchmark::Errors all{nan, nan}, seen{nan, nan}, dis_all{nan, nan},
      dis_seen{nan, nan};
  double own3d = nan;
  if (!truth.empty()) {
    own = benchmark::endPointErrors (run.flow.flow, truth, visible, reference.depth);
    if (!dis.empty())
      other = benchmark::endPointErrors (dis, truth, visible, reference.depth);
  }
  if (!truth3d.empty())
    own3d = benchmark::meanError3d (
        run.flow.displacement, truth3d, visible, reference.depth);
  if (!dis.empty()) {
    const cv::Mat& mask = run.flow.visibility;
    all = benchmark::brightnessResiduals (run.flow.flow, reference, current);
    dis_all = benchmark::brightnessResiduals (dis, reference, current);
    seen = benchmark::brightnessResiduals (run.flow.flow, reference, current, mask);
    dis_seen = benchmark::brightnessResiduals (dis, reference, current, mask);
  }
  const double share = static_cast<double> (cv::countNonZero (
                           run.flow.visibility == static_cast<int> (Visible))) /
                       cv::countNonZero (run.flow.visibility);
  std::printf ("| %s | %zu / %d | %s (%s) | %s | %s | %s | %s | %s | %.2f | %.0f |\n",
               std::filesystem::path (path).filename().c_str(),
               run.flow.segments.size(),
               run.flow.bodies,
               cell ("%.3f", own.mean).c_str(),
               cell ("%.3f", own.median).c_str(),
               cell ("%.2f", own3d).c_str(),
               cell ("%.3f", other.mean).c_str(),
               cell ("%.2f", all.mean / dis_all.mean).c_str(),
               cell ("%.2f", all.median / dis_all.median).c_str(),
               cell ("%.2f", seen.mean / dis_seen.mean).c_str(),
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
