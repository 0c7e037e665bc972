// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/datasets/dataset_kinds.h"
#include "io/datasets/file_lists.h"
#include "io/datasets/frame_parts.h"
#include "io/datasets/listed_sequence.h"
#include "io/datasets/text_table.h"
#include "io/datasets/truth_parts.h"
#include "io/datasets/virtual_kitti_files.h"
#include <pcl_msf/errors.h>

#include <map>
#include <utility>

namespace pcl_msf::io {

namespace {

/** Folders of one scene and variation: merged, or one archive for each kind of data. */
struct Place {
  std::string folder; ///< SceneXX/VARIATION, of the colour images
  std::string camera; ///< "Camera_0" is the left one

  std::string
  images (const std::string& kind) const
  {
    const std::string part = "frames/" + kind + "/" + camera;
    const std::string merged = inside (folder, part);
    const std::string other = inOtherArchive (folder, "rgb", kind);
    return isFolder (merged) || other.empty() ? merged : inside (other, part);
  }

  std::string
  table (const std::string& name) const
  {
    const std::string merged = inside (folder, name);
    const std::string other = inOtherArchive (folder, "rgb", "textgt");
    return isFile (merged) || other.empty() ? merged : inside (other, name);
  }
};

class VirtualKitti2Sequence : public ListedSequence {
public:
  VirtualKitti2Sequence (std::string name, Place place, std::vector<FrameFiles> files)
  : ListedSequence (std::move (name), std::move (files), 100.0)
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
    if (follows (from, to))
      return read ("forwardFlow/flow_", "forwardSceneFlow/sceneFlow_", from, to);
    if (follows (to, from))
      return read ("backwardFlow/backwardFlow_",
                   "backwardSceneFlow/backwardSceneFlow_",
                   from,
                   to);
    return {};
  }

protected:
  cv::Mat
  depth (const FrameFiles& files) const override
  {
    return readVirtualKittiDepth (files.depth);
  }

private:
  /** Of "kind/stem" that of a frame. */
  std::string
  truthFile (const std::string& kind_and_stem, int frame) const
  {
    const std::size_t slash = kind_and_stem.find ('/');
    return inside (place_.images (kind_and_stem.substr (0, slash)),
                   kind_and_stem.substr (slash + 1) + padded (frame, 5) + ".png");
  }

  MotionTruth
  read (const std::string& flow_stem,
        const std::string& scene_flow_stem,
        int from,
        int to) const
  {
    MotionTruth truth;
    const std::string flow = truthFile (flow_stem, files (from).number);
    const std::string scene_flow = truthFile (scene_flow_stem, files (from).number);
    const cv::Mat first = depth (files (from));
    if (isFile (flow)) {
      truth.flow = readVirtualKittiFlow (flow);
      requireSize (flow, truth.flow, first.size());
    }
    if (isFile (scene_flow)) {
      truth.scene_flow = readVirtualKittiSceneFlow (scene_flow);
      requireSize (scene_flow, truth.scene_flow, first.size());
    }
    if (!truth.flow.empty() && !truth.scene_flow.empty()) {
      cv::Mat moved_z;
      cv::extractChannel (truth.scene_flow, moved_z, 2);
      truth.visible = seenInBoth (truth.flow, first + moved_z, depth (files (to)));
    }
    return truth;
  }

  Place place_;
};

/** Rows of a table by frame, for one camera; it begins with a line of names. */
std::map<int, std::size_t>
rowsOf (const TextTable& table, int camera)
{
  std::map<int, std::size_t> rows;
  for (std::size_t row = 0; row < table.rows(); ++row)
    if (table.wholeNumber (row, 1, "cameraID") == camera)
      rows[table.wholeNumber (row, 0, "frame")] = row;
  return rows;
}

std::map<int, PinholeCamera>
readCameras (const std::string& path, int camera)
{
  std::map<int, PinholeCamera> cameras;
  const TextTable table (path, 1);
  for (const auto& [frame, row] : rowsOf (table, camera))
    cameras[frame] = {table.number (row, 2, "K[0,0]"),
                      table.number (row, 3, "K[1,1]"),
                      table.number (row, 4, "K[0,2]"),
                      table.number (row, 5, "K[1,2]")};
  return cameras;
}

std::map<int, RigidPose>
readExtrinsics (const std::string& path, int camera)
{
  std::map<int, RigidPose> poses;
  const TextTable table (path, 1);
  for (const auto& [frame, row] : rowsOf (table, camera))
    poses[frame] = table.pose (row, 2);
  return poses;
}

std::shared_ptr<const RgbdSequence>
openOne (const Place& place, const DatasetOptions& options)
{
  const int camera = place.camera == "Camera_0" ? 0 : 1;
  std::map<int, PinholeCamera> cameras;
  if (!options.camera)
    cameras = readCameras (place.table ("intrinsic.txt"), camera);
  std::map<int, RigidPose> poses;
  if (isFile (place.table ("extrinsic.txt")))
    poses = readExtrinsics (place.table ("extrinsic.txt"), camera);
  std::vector<FrameFiles> files;
  for (const std::string& color : filesIn (place.images ("rgb"), {".jpg", ".png"})) {
    FrameFiles frame;
    frame.color = color;
    frame.number = trailingNumber (color);
    const int k = frame.number;
    frame.depth = inside (place.images ("depth"), "depth_" + padded (k, 5) + ".png");
    if (!options.camera && cameras.count (k) == 0)
      throw IoError (place.table ("intrinsic.txt") + ": frame: none for frame " +
                     std::to_string (k) + " of camera " + std::to_string (camera) +
                     "; give the file of the data set, or the camera");
    frame.camera = options.camera ? *options.camera : cameras[k];
    if (poses.count (k) != 0)
      frame.world_from_camera = poses[k].inverse();
    files.push_back (frame);
  }
  return std::make_shared<VirtualKitti2Sequence> (
      lastName (parentFolder (place.folder)) + "/" + lastName (place.folder),
      place,
      std::move (files));
}

} // namespace

Sequences
openVirtualKitti2 (const std::string& path, const DatasetOptions& options)
{
  const std::string camera = options.view == StereoView::Left ? "Camera_0" : "Camera_1";
  const auto isSequence = [&camera] (const std::string& folder) {
    return lastName (parentFolder (folder)).rfind ("Scene", 0) == 0 &&
           isFolder (inside (folder, "frames/rgb/" + camera));
  };
  Sequences sequences;
  for (const std::string& folder : foldersWhere (path, isSequence))
    sequences.push_back (openOne ({folder, camera}, options));
  return sequences;
}

} // namespace pcl_msf::io
