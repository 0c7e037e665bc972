// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
//
// Visual odometry of data folders with recorded poses: the tracker beside
// frame-to-frame chaining and windows that share a frame. With FRAMES above a folder's
// number the tracker goes back and forth over it, and its memory is printed now and
// then.

#include <pcl_msf/evaluation/trajectory_errors.h>
#include <pcl_msf/io/data_folder.h>
#include <pcl_msf/io/float_files.h>
#include <pcl_msf/multiframe_estimator.h>
#include <pcl_msf/scene_flow_estimator.h>
#include <pcl_msf/scene_flow_tracker.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace {

using namespace pcl_msf;
using Poses = std::vector<RigidPose>;

struct Options {
  int frames;
  int window;
  bool rigid;
};

double
processorSeconds ()
{
  rusage usage{};
  getrusage (RUSAGE_SELF, &usage);
  return static_cast<double> (usage.ru_utime.tv_sec) +
         1e-6 * static_cast<double> (usage.ru_utime.tv_usec);
}

double
residentMegabytes ()
{
  long pages = 0, resident = 0;
  std::ifstream ("/proc/self/statm") >> pages >> resident;
  return static_cast<double> (resident) * static_cast<double> (sysconf (_SC_PAGESIZE)) /
         1e6;
}

SegmentationParameters
segmentation (const Options& options)
{
  SegmentationParameters parameters;
  if (options.rigid)
    parameters.method = SegmentationMethod::Single;
  return parameters;
}

RgbdFrame
load (const io::DataFolder& folder, int k)
{
  const io::RgbdImages images = folder.frame (k);
  return RgbdFrame::fromImages (images.color, images.depth, images.camera);
}

/** world_from_camera of frames that share a frame window by window. */
Poses
ofWindows (const std::vector<RgbdFrame>& frames, int window, const Options& options)
{
  Poses poses{RigidPose{}};
  const int count = static_cast<int> (frames.size());
  for (int first = 0; first + 1 < count; first += window - 1) {
    const int end = std::min (count, first + window);
    const std::vector<RgbdFrame> part (frames.begin() + first, frames.begin() + end);
    const MultiframeSceneFlow result = MultiframeEstimator().estimate (
        part, 0, Oversegmentation::fromFrame (part[0], segmentation (options)));
    const RigidPose start = poses.back();
    for (int k = 1; k < end - first; ++k)
      poses.push_back (start * result.frames[k].dominant_motion.inverse());
  }
  return poses;
}

TrackerParameters
trackerParameters (const Options& options, bool merge)
{
  TrackerParameters parameters;
  parameters.window = options.window;
  parameters.merge_segments = merge;
  return parameters;
}

/** Mean end-point error of the flow from the first frame, where it is visible. */
double
endPointError (const SceneFlow& scene, const std::string& folder, int frame)
{
  const std::string file = folder + "/gt/flow_0_" + std::to_string (frame) + ".flo";
  if (!std::filesystem::exists (file))
    return std::nan ("");
  const cv::Mat truth = io::readFlow (file);
  double sum = 0.0;
  int count = 0;
  for (int y = 0; y < truth.rows; ++y)
    for (int x = 0; x < truth.cols; ++x) {
      const cv::Vec2f off =
          scene.flow.at<cv::Vec2f> (y, x) - truth.at<cv::Vec2f> (y, x);
      if (scene.visibility.at<unsigned char> (y, x) != Visibility::Visible ||
          !(std::hypot (off[0], off[1]) < 1e6f))
        continue;
      sum += std::hypot (off[0], off[1]);
      ++count;
    }
  return sum / count;
}

Poses
ofTracker (const std::vector<RgbdFrame>& frames,
           const TrackerParameters& parameters,
           const Options& options,
           const std::string& folder)
{
  SolverParameters solver;
  solver.threads = 1;
  SceneFlowTracker tracker (parameters, segmentation (options), {}, solver, {});
  Poses poses;
  std::string errors;
  for (const RgbdFrame& frame : frames) {
    tracker.add (frame);
    poses.push_back (tracker.cameraPose());
    if (tracker.frames() > 1 && tracker.firstFrame() == 0) {
      char text[32];
      std::snprintf (text,
                     sizeof text,
                     " %.3f",
                     endPointError (tracker.sceneFlow(),
                                    folder,
                                    static_cast<int> (poses.size()) - 1));
      errors += text;
    }
  }
  std::printf ("end-point errors, px:%s\n", errors.c_str());
  return poses;
}

void
printAccuracy (const std::string& name,
               const std::string& path,
               const io::DataFolder& folder,
               Options options)
{
  std::vector<RgbdFrame> frames;
  Poses truth{RigidPose{}};
  for (int k = 0; k < std::min (folder.frames(), options.frames); ++k) {
    frames.push_back (load (folder, k));
    if (k > 0)
      truth.push_back (folder.pose (k).value_or (RigidPose{}).inverse());
  }
  const bool known = folder.pose (1).has_value();
  const auto row = [&] (const std::string& method, const std::function<Poses()>& run) {
    const double begin = processorSeconds();
    const Poses poses = run();
    const double seconds =
        (processorSeconds() - begin) / static_cast<double> (poses.size() - 1);
    const double nothing = std::nan ("");
    const auto step = known ? evaluation::relativePoseError (poses, truth)
                            : evaluation::RelativePoseError{nothing, nothing};
    const double ate =
        known ? evaluation::absoluteTrajectoryError (poses, truth) : nothing;
    std::printf ("| %s | %zu | %s | %.2f | %.2f | %.3f | %.2f |\n",
                 name.c_str(),
                 poses.size(),
                 method.c_str(),
                 1e3 * ate,
                 1e3 * step.translation,
                 step.rotation_deg,
                 seconds);
    std::fflush (stdout);
  };
  const std::string n = std::to_string (options.window);
  row ("frame to frame", [&] { return ofWindows (frames, 2, options); });
  row ("windows of " + n, [&] { return ofWindows (frames, options.window, options); });
  row ("tracker, joint " + n, [&] {
    const TrackerParameters joint = trackerParameters (options, false);
    return ofTracker (frames, joint, options, path);
  });
  row ("tracker", [&] { return ofTracker (frames, {}, options, path); });
}

/** Back and forth over the folder, as an endless recording. */
void
printMemory (const std::string& name, const io::DataFolder& folder, Options options)
{
  constexpr int kEvery = 25;
  SceneFlowTracker tracker (
      trackerParameters (options, false), segmentation (options), {}, {}, {});
  const int turn = 2 * (folder.frames() - 1);
  for (int k = 0; k < options.frames; ++k) {
    const int at = k % turn;
    tracker.add (load (folder, at < folder.frames() ? at : turn - at));
    if (k % kEvery == kEvery - 1) {
      std::printf ("| %s | %d | %.1f | %ld | %d |\n",
                   name.c_str(),
                   k + 1,
                   residentMegabytes(),
                   tracker.firstFrame(),
                   tracker.segments().size());
      std::fflush (stdout);
    }
  }
}

void
run (const std::string& path, const Options& options)
{
  const io::DataFolder folder (path);
  const std::string name = std::filesystem::path (path).filename();
  if (options.frames > folder.frames())
    printMemory (name, folder, options);
  else
    printAccuracy (name, path, folder, options);
}

} // namespace

int
main (int argc, char** argv)
{
  if (argc < 4) {
    std::fprintf (
        stderr, "Syntax: %s FRAMES WINDOW[r] FOLDER ... (r: rigid)\n", argv[0]);
    return 2;
  }
  const std::string window = argv[2];
  const Options options{std::atoi (argv[1]), std::atoi (argv[2]), window.back() == 'r'};
  std::printf (
      "Within a folder:  | case | frames | method | ATE mm | a step: mm | deg | "
      "processor s a frame |\n"
      "back and forth:   | case | frames | resident MB | reference | segments "
      "|\n");
  int failures = 0;
  for (int i = 3; i < argc; ++i)
    try {
      run (argv[i], options);
    }
    catch (const std::exception& error) {
      std::fprintf (stderr, "%s: %s\n", argv[i], error.what());
      ++failures;
    }
  return failures == 0 ? 0 : 1;
}
