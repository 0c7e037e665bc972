// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Mayer et al., "A Large Dataset to Train Convolutional Networks for Disparity, Optical
// Flow, and Scene Flow Estimation", CVPR 2016, and the formats on its web page.
#include "io/datasets/dataset_kinds.h"
#include "io/datasets/file_lists.h"
#include "io/datasets/flying_things_files.h"
#include "io/datasets/frame_parts.h"
#include "io/datasets/listed_sequence.h"
#include "io/datasets/truth_parts.h"

#include <filesystem>
#include <utility>

namespace pcl_msf::io {

namespace {

constexpr double kBaseline = 1.0;
const cv::Size kSize (960, 540);

/** The published camera: 35 mm, or 15 mm for a part of Driving. */
PinholeCamera
publishedCamera (const std::string& sequence)
{
  const bool wide = sequence.find ("15mm_focallength") != std::string::npos;
  const double focal = wide ? 450.0 : 1050.0;
  return {focal, focal, 479.5, 269.5};
}

class FlyingThingsSequence : public ListedSequence {
public:
  FlyingThingsSequence (FlyingThingsPlace place,
                        std::vector<FrameFiles> files,
                        const cv::Size& size)
  : ListedSequence (place.sequence, std::move (files), 1.0, size)
  , place_ (std::move (place))
  {}

  bool
  definesDepthUnit () const override
  {
    return true;
  }

  MotionTruth
  truth (int from, int to) const override
  {
    const bool future = follows (from, to);
    if (!future && !follows (to, from))
      return {};
    MotionTruth truth;
    const FrameFiles& first = files (from);
    const FrameFiles& second = files (to);
    const std::string stem = std::filesystem::path (first.color).stem().string();
    const std::string flow = place_.flow (stem, future);
    const std::string change = place_.disparityChange (stem, future);
    const cv::Mat disparity = readDisparity (first.depth);
    if (isFile (flow)) {
      truth.flow = readFlyingThingsFlow (flow);
      requireSize (flow, truth.flow, disparity.size());
    }
    if (truth.flow.empty() || !isFile (change))
      return truth;
    const cv::Mat moved = readDisparityChange (change);
    requireSize (change, moved, disparity.size());
    const cv::Mat z = depth (first);
    const cv::Mat later_z = depthFromDisparity (laterDisparity (disparity, moved),
                                                second.camera.fx * kBaseline);
    truth.scene_flow =
        sceneFlowFrom (z, truth.flow, later_z, first.camera, second.camera);
    truth.visible = seenInBoth (truth.flow, later_z, depth (second));
    return truth;
  }

protected:
  cv::Mat
  depth (const FrameFiles& files) const override
  {
    return depthFromDisparity (cv::abs (readDisparity (files.depth)),
                               files.camera.fx * kBaseline);
  }

private:
  FlyingThingsPlace place_;
};

std::shared_ptr<const RgbdSequence>
openOne (const FlyingThingsPlace& place,
         const std::vector<std::string>& images,
         const DatasetOptions& options)
{
  std::map<int, RigidPose> poses;
  if (isFile (place.cameraData()))
    poses = readCameraData (place.cameraData(), place.view == "left" ? 'L' : 'R');
  std::vector<FrameFiles> files;
  for (const std::string& image : images) {
    const std::string stem = std::filesystem::path (image).stem().string();
    FrameFiles frame;
    frame.color = image;
    frame.number = trailingNumber (image);
    frame.depth = place.disparity (stem);
    frame.camera = options.camera.value_or (publishedCamera (place.sequence));
    const auto pose = poses.find (frame.number);
    if (pose != poses.end())
      frame.world_from_camera = pose->second;
    files.push_back (frame);
  }
  return std::make_shared<FlyingThingsSequence> (
      place, std::move (files), options.camera ? cv::Size() : kSize);
}

} // namespace

Sequences
openFlyingThings (const std::string& path, const DatasetOptions& options)
{
  const auto isSequence = [&options] (const std::string& folder) {
    return lastName (folder) == toString (options.view) &&
           findFlyingThings (folder, toString (options.pass)).has_value();
  };
  Sequences sequences;
  for (const std::string& folder : foldersWhere (path, isSequence)) {
    const std::vector<std::string> images = filesIn (folder, {".png", ".webp"});
    if (!images.empty())
      sequences.push_back (openOne (
          *findFlyingThings (folder, toString (options.pass)), images, options));
  }
  return sequences;
}

} // namespace pcl_msf::io
