// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <Eigen/Geometry>

#include "core/base/number_text.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/float_files.h>
#include <pcl_msf/io/folders.h>
#include <pcl_msf/io/images.h>
#include <pcl_msf/io/text_files.h>
#include <pcl_msf/synthetic/sequence_writer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace pcl_msf::synthetic {
namespace {

/** Depth as Sintel has it: 0 where nothing was hit. */
void
writeFloatDepth (const std::string& file, const cv::Mat& depth)
{
  cv::Mat known = depth.clone();
  cv::patchNaNs (known, 0.0);
  io::writeDpt (file, known);
}

/** The upper 3x4 of a pose, row by row, each number with a blank behind it. */
std::string
rowsOf (const RigidPose& pose)
{
  std::string text;
  const Eigen::Matrix3d r = pose.rotation();
  const Eigen::Vector3d t = pose.translation();
  for (int i = 0; i < 3; ++i)
    for (const double number : {r (i, 0), r (i, 1), r (i, 2), t[i]})
      text += generalText (number, 17) + ' ';
  return text;
}

std::string
objectPoses (const SyntheticSequence& sequence, std::size_t k)
{
  std::string text =
      "# label rigid r11 r12 r13 tx r21 r22 r23 ty r31 r32 r33 tz name\n";
  for (std::size_t label = 0; label < sequence.bodies.size(); ++label) {
    const SyntheticBody& body = sequence.bodies[label];
    text += std::to_string (label) + (body.rigid ? " 1 " : " 0 ") +
            rowsOf (body.framek_from_frame0[k]) + body.name + '\n';
  }
  return text;
}

bool
hasFloatDepth (const SyntheticSequence& sequence, const SequenceWriterOptions& options)
{
  return options.depth_format == DepthFormat::Float ||
         (options.depth_format == DepthFormat::Automatic &&
          sequence.options.sensor == Sensor::Ideal);
}

/** Refuses a scale with which most depths are less than one unit, or all too many. */
void
requireScale (const SyntheticSequence& sequence, double scale)
{
  constexpr double kMostUnits = 65534.0; // of 16 bit, as io::writeDepth has it
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  std::size_t measured = 0, below = 0, beyond = 0;
  for (const SyntheticFrame& frame : sequence.frames)
    for (const float z : cv::Mat_<float> (frame.depth)) {
      if (!(z > 0.0F))
        continue;
      least = std::min<double> (least, z);
      most = std::max<double> (most, z);
      ++measured;
      below += z * scale < 1.0;
      beyond += std::round (z * scale) > kMostUnits;
    }
  if (measured == 0 || (2 * below <= measured && below + beyond < measured))
    return;
  throw InvalidInput (
      "depth_scale = " + generalText (scale) + " holds " +
      generalText (1.0 / scale, 4) + " to " + generalText (kMostUnits / scale, 4) +
      " m in 16 bit, the scene's depth " + "is " + generalText (least, 4) + " to " +
      generalText (most, 4) + " m; give another one, for example " +
      (most < 13.0 ? "5000" : "1000"));
}

void
writeCaseTruth (const SyntheticSequence& sequence, const std::string& folder)
{
  io::makeFolder (folder);
  cv::Mat labels;
  cv::Mat shown = sequence.labels.clone();
  shown.setTo (255, sequence.labels < 0);
  shown.convertTo (labels, CV_8UC1);
  io::writeImage (folder + "/labels_0.png", labels);
  for (std::size_t k = 1; k < sequence.truth.size(); ++k) {
    const GroundTruth& truth = sequence.truth[k];
    const std::string number = std::to_string (k);
    io::writeFlow (folder + "/flow_0_" + number + ".flo", truth.flow);
    io::writePfm (folder + "/scene_flow_0_" + number + ".pfm", truth.scene_flow);
    io::writeImage (folder + "/visible_0_" + number + ".png", truth.visible);
    io::writePose (folder + "/pose_" + number + ".txt",
                   sequence.bodies[0].framek_from_frame0[k]);
    io::writeText (folder + "/object_poses_" + number + ".txt",
                   objectPoses (sequence, k));
  }
}

void
writeCase (const SyntheticSequence& sequence,
           const std::string& folder,
           const SequenceWriterOptions& options)
{
  const bool as_float = hasFloatDepth (sequence, options);
  for (std::size_t k = 0; k < sequence.frames.size(); ++k) {
    const SyntheticFrame& frame = sequence.frames[k];
    const std::string number = std::to_string (k);
    io::writeImage (folder + "/color_" + number + ".png", frame.color);
    if (as_float)
      writeFloatDepth (folder + "/depth_" + number + ".dpt", frame.depth);
    else
      io::writeDepth (
          folder + "/depth_" + number + ".png", frame.depth, options.depth_scale);
  }
  const cv::Size size = sequence.labels.size();
  io::writeCamera (
      folder + "/camera.txt",
      {sequence.camera, size.width, size.height, as_float ? 1.0 : options.depth_scale});
  writeCaseTruth (sequence, folder + "/gt");
}

void
writeTum (const SyntheticSequence& sequence, const std::string& folder)
{
  io::makeFolder (folder + "/rgb");
  io::makeFolder (folder + "/depth");
  std::string rgb = "# color images\n# timestamp filename\n";
  std::string depth = "# depth maps\n# timestamp filename\n";
  std::string poses = "# ground truth trajectory\n# timestamp tx ty tz qx qy qz qw\n";
  for (std::size_t k = 0; k < sequence.frames.size(); ++k) {
    const std::string time = fixedText (1.0 + static_cast<double> (k) / 30.0, 6);
    const std::string name = time + ".png";
    io::writeImage (folder + "/rgb/" + name, sequence.frames[k].color);
    io::writeDepth (folder + "/depth/" + name, sequence.frames[k].depth, 5000.0);
    rgb += time + " rgb/" + name + '\n';
    depth += time + " depth/" + name + '\n';
    const RigidPose& pose = sequence.frame0_from_framek[k];
    const Eigen::Vector3d t = pose.translation();
    const Eigen::Quaterniond q (pose.rotation());
    poses += time;
    for (const double n : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()})
      poses += ' ' + generalText (n, 9);
    poses += '\n';
  }
  io::writeText (folder + "/rgb.txt", rgb);
  io::writeText (folder + "/depth.txt", depth);
  io::writeText (folder + "/groundtruth.txt", poses);
}

void
writeSintelTruth (const GroundTruth& truth,
                  const std::string& folder,
                  const std::string& file)
{
  for (const char* kind : {"flow", "occlusions", "invalid"})
    io::makeFolder (folder + "/" + kind + file.substr (0, file.rfind ('/')));
  io::writeFlow (folder + "/flow" + file + ".flo", truth.flow);
  cv::Mat invalid (truth.flow.size(), CV_8UC1, cv::Scalar (255));
  for (int v = 0; v < invalid.rows; ++v)
    for (int u = 0; u < invalid.cols; ++u) {
      const cv::Vec2f f = truth.flow.at<cv::Vec2f> (v, u);
      const double x = u + f[0], y = v + f[1];
      if (x >= -0.5 && y >= -0.5 && x < invalid.cols - 0.5 && y < invalid.rows - 0.5)
        invalid.at<unsigned char> (v, u) = 0;
    }
  io::writeImage (folder + "/invalid" + file + ".png", invalid);
  io::writeImage (folder + "/occlusions" + file + ".png", ~truth.visible & ~invalid);
}

void
writeSintel (const SyntheticSequence& sequence,
             const std::string& folder,
             const std::string& name)
{
  for (const char* kind : {"clean", "depth", "camdata_left"})
    io::makeFolder (folder + "/" + kind + "/" + name);
  for (std::size_t k = 0; k < sequence.frames.size(); ++k) {
    const std::string number = std::to_string (10000 + k + 1).substr (1);
    const std::string file = "/" + name + "/frame_" + number;
    io::writeImage (folder + "/clean" + file + ".png", sequence.frames[k].color);
    writeFloatDepth (folder + "/depth" + file + ".dpt", sequence.frames[k].depth);
    io::writeCam (folder + "/camdata_left" + file + ".cam",
                  sequence.camera,
                  sequence.frame0_from_framek[k].inverse());
    if (k < sequence.successive_truth.size())
      writeSintelTruth (sequence.successive_truth[k], folder, file);
    else if (k == 0 && sequence.truth.size() > 1)
      writeSintelTruth (sequence.truth[1], folder, file);
  }
}

} // namespace

void
writeSequence (const SyntheticSequence& sequence,
               const std::string& folder,
               const SequenceWriterOptions& options)
{
  if (sequence.frames.empty())
    throw InvalidInput ("cannot write a sequence without frames to " + folder);
  if (!(options.depth_scale > 0.0) || !std::isfinite (options.depth_scale))
    throw InvalidInput ("depth_scale must be positive");
  if (options.layout == SequenceLayout::Cases && !hasFloatDepth (sequence, options))
    requireScale (sequence, options.depth_scale);
  io::makeFolder (folder);
  switch (options.layout) {
  case SequenceLayout::Cases:
    return writeCase (sequence, folder, options);
  case SequenceLayout::Tum:
    return writeTum (sequence, folder);
  case SequenceLayout::Sintel:
    return writeSintel (sequence,
                        folder,
                        options.name.empty() ? toString (sequence.options.scene)
                                             : options.name);
  }
}

} // namespace pcl_msf::synthetic
