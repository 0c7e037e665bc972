// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Sturm et al., "A Benchmark for the Evaluation of RGB-D SLAM Systems", IROS 2012, and
// the file formats and intrinsics on its web pages.
#include "io/datasets/dataset_kinds.h"
#include "io/datasets/file_lists.h"
#include "io/datasets/frame_parts.h"
#include "io/datasets/listed_sequence.h"
#include "io/datasets/timed_lists.h"
#include <pcl_msf/errors.h>

namespace pcl_msf::io {

namespace {

constexpr double kDepthScale = 5000.0;

/** The published calibrations of the three sensors, else ROS' default. */
CameraChoice
cameraNamed (const std::string& name)
{
  const auto with = [] (const PinholeCamera& camera, const LensDistortion& lens) {
    return CameraChoice{camera, lens, kDepthScale, {640, 480}};
  };
  const auto has = [&name] (const char* part) {
    return name.find (part) != std::string::npos;
  };
  if (has ("freiburg1") || has ("fr1"))
    return with ({517.3, 516.5, 318.6, 255.3},
                 {0.2624, -0.9531, -0.0054, 0.0026, 1.1633});
  if (has ("freiburg2") || has ("fr2"))
    return with ({520.9, 521.0, 325.1, 249.7},
                 {0.2312, -0.7849, -0.0033, -0.0001, 0.9172});
  if (has ("freiburg3") || has ("fr3"))
    return with ({535.4, 539.2, 320.1, 247.6}, {});
  return with ({525.0, 525.0, 319.5, 239.5}, {});
}

std::shared_ptr<const RgbdSequence>
openOne (const std::string& name,
         const std::string& folder,
         const DatasetOptions& options)
{
  auto color = readTimedFiles (inside (folder, "rgb.txt"));
  auto depth = readTimedFiles (inside (folder, "depth.txt"));
  matchUnits (color, depth, options.max_time_difference);
  const std::string trajectory = inside (folder, "groundtruth.txt");
  const auto poses =
      isFile (trajectory) ? readTrajectory (trajectory) : std::vector<TimedPose>();
  const auto pairs = associate (color, depth, options.max_time_difference);
  if (pairs.empty())
    throw IoError (
        inside (folder, "depth.txt") + ": timestamp: " +
        nothingAssociated (
            color, depth, options.max_time_difference, {"rgb.txt", "depth.txt"}));
  const CameraChoice choice =
      chooseCamera (folder, options, cameraNamed (lastName (folder)));
  std::vector<FrameFiles> files;
  for (const auto& [c, d] : pairs)
    files.push_back ({inside (folder, color[c].file),
                      inside (folder, depth[d].file),
                      choice.camera,
                      color[c].time,
                      poseAt (poses, color[c].time, options.max_time_difference),
                      choice.distortion});
  return std::make_shared<ListedSequence> (
      name, std::move (files), choice.depth_scale, choice.size, choice.float_scale);
}

} // namespace

Sequences
openTum (const std::string& path, const DatasetOptions& options)
{
  const auto isSequence = [] (const std::string& folder) {
    return isFile (inside (folder, "rgb.txt")) || isFile (inside (folder, "depth.txt"));
  };
  Sequences sequences;
  for (const std::string& folder : foldersWhere (path, isSequence))
    sequences.push_back (openOne (nameBelow (path, folder), folder, options));
  return sequences;
}

} // namespace pcl_msf::io
