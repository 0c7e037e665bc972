// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/datasets/dataset_kinds.h"
#include "io/datasets/file_lists.h"
#include "io/datasets/frame_parts.h"
#include "io/datasets/listed_sequence.h"
#include "io/datasets/text_table.h"
#include "io/datasets/virtual_kitti_files.h"
#include <pcl_msf/errors.h>

#include <map>
#include <utility>

namespace pcl_msf::io {

namespace {

/** The published camera and size of all images. */
const PinholeCamera kCamera{725.0, 725.0, 620.5, 187.0};
const cv::Size kSize (1242, 375);

class VirtualKitti1Sequence : public ListedSequence {
public:
  using ListedSequence::ListedSequence;

  bool
  definesDepthUnit () const override
  {
    return true;
  }

  MotionTruth
  truth (int from, int to) const override
  {
    MotionTruth truth;
    const std::string flow = inOtherArchive (files (from).color, "rgb", "flowgt");
    if (!follows (from, to) || !isFile (flow))
      return truth;
    truth.flow = readVirtualKittiFlow (flow);
    requireSize (flow, truth.flow, imageSize (from));
    return truth;
  }

protected:
  cv::Mat
  depth (const FrameFiles& files) const override
  {
    return readVirtualKittiDepth (files.depth);
  }
};

/** `camera_from_world` by frame; the file begins with a line of column names. */
std::map<int, RigidPose>
readExtrinsics (const std::string& path)
{
  std::map<int, RigidPose> poses;
  const TextTable table (path, 1);
  for (std::size_t row = 0; row < table.rows(); ++row)
    poses[table.wholeNumber (row, 0, "frame")] = table.pose (row, 1);
  return poses;
}

std::shared_ptr<const RgbdSequence>
openOne (const std::string& folder, const DatasetOptions& options)
{
  const std::string world = lastName (parentFolder (folder));
  const std::string variation = lastName (folder);
  const std::string extrinsics = inside (
      parentFolder (parentFolder (inOtherArchive (folder, "rgb", "extrinsicsgt"))),
      world + "_" + variation + ".txt");
  std::map<int, RigidPose> poses;
  if (isFile (extrinsics))
    poses = readExtrinsics (extrinsics);
  std::vector<FrameFiles> files;
  for (const std::string& color : filesIn (folder, {".png", ".jpg"})) {
    FrameFiles frame;
    frame.color = color;
    frame.number = trailingNumber (color);
    frame.depth = inOtherArchive (color, "rgb", "depthgt");
    frame.camera = options.camera.value_or (kCamera);
    const auto pose = poses.find (frame.number);
    if (pose != poses.end())
      frame.world_from_camera = pose->second.inverse();
    files.push_back (frame);
  }
  return std::make_shared<VirtualKitti1Sequence> (world + "/" + variation,
                                                  std::move (files),
                                                  100.0,
                                                  options.camera ? cv::Size() : kSize);
}

} // namespace

Sequences
openVirtualKitti1 (const std::string& path, const DatasetOptions& options)
{
  const auto isSequence = [] (const std::string& folder) {
    const std::string archive = lastName (parentFolder (parentFolder (folder)));
    return archive.rfind ("vkitti_1", 0) == 0 &&
           !inOtherArchive (archive, "rgb", "depthgt").empty() &&
           !filesIn (folder, {".png", ".jpg"}).empty();
  };
  Sequences sequences;
  for (const std::string& folder : foldersWhere (path, isSequence))
    sequences.push_back (openOne (folder, options));
  return sequences;
}

} // namespace pcl_msf::io
