// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/datasets/body_poses.h"
#include "io/datasets/dataset_kinds.h"
#include "io/datasets/file_lists.h"
#include "io/datasets/frame_parts.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/cloud_files.h>
#include <pcl_msf/io/data_folder.h>
#include <pcl_msf/io/images.h>
#include <pcl_msf/io/undistortion.h>

#include <utility>

namespace pcl_msf::io {

namespace {

class CaseSequence : public RgbdSequence {
public:
  CaseSequence (std::string name,
                const std::string& path,
                const DatasetOptions& options)
  : name_ (std::move (name)), folder_ (path), options_ (options)
  {
    if (options.distortion && folder_.depthPath (0).empty())
      throw InvalidInput ("distortion: " + path +
                          " holds clouds, which have none; leave it away");
  }

  std::string
  name () const override
  {
    return name_;
  }

  int
  frames () const override
  {
    return folder_.frames();
  }

  RgbdImages
  frame (int k) const override
  {
    requireFrame (k);
    if (!options_.camera && !options_.distortion)
      return folder_.frame (k, options_.depth_scale);
    RgbdImages images = folder_.storedFrame (k, options_.depth_scale);
    if (options_.camera)
      images.camera = *options_.camera;
    if (options_.distortion)
      undistort (images, *options_.distortion);
    return images;
  }

  MotionTruth
  truth (int from, int to) const override
  {
    requireFrame (from);
    requireFrame (to);
    MotionTruth truth;
    truth.labels = folder_.labels (from);
    if (from == 0 && to != 0) {
      truth.flow = folder_.flow (to);
      truth.scene_flow = folder_.sceneFlow (to);
      truth.visible = folder_.visible (to);
    }
    const auto from_pose = poseOf (from), to_pose = poseOf (to);
    if (!from_pose || !to_pose)
      return truth;
    const BodyPoses from_bodies = bodiesOf (from), to_bodies = bodiesOf (to);
    truth.bodies = motionBetween (from_bodies, to_bodies);
    if (isOneBody (from_bodies, to_bodies))
      truth.rigid = *to_pose * from_pose->inverse();
    return truth;
  }

  std::optional<RigidPose>
  cameraPose (int k) const override
  {
    requireFrame (k);
    const auto pose = poseOf (k);
    return pose ? std::optional (pose->inverse()) : std::nullopt;
  }

private:
  void
  requireFrame (int k) const
  {
    if (k < 0 || k >= frames())
      throw InvalidInput (noSuchFrame (name_, k, frames()));
  }

  /** Of the static scene, frame k from frame 0; of frame 0 when any other has one. */
  std::optional<RigidPose>
  poseOf (int k) const
  {
    if (k != 0)
      return folder_.pose (k);
    for (int other = 1; other < frames(); ++other)
      if (isFile (truthFile ("pose_", other)))
        return RigidPose();
    return std::nullopt;
  }

  std::string
  truthFile (const std::string& stem, int k) const
  {
    return inside (folder_.path(), "gt/" + stem + std::to_string (k) + ".txt");
  }

  /** None for frame 0, whose poses are the identity. */
  BodyPoses
  bodiesOf (int k) const
  {
    const std::string path = truthFile ("object_poses_", k);
    return k != 0 && isFile (path) ? readBodyPoses (path) : BodyPoses();
  }

  /** Without a list of bodies, the labels tell. */
  bool
  isOneBody (const BodyPoses& from, const BodyPoses& to) const
  {
    const BodyPoses& bodies = to.empty() ? from : to;
    if (!bodies.empty())
      return bodies.size() == 1 && bodies.front().has_value();
    const cv::Mat labels = folder_.labels (0);
    double largest = 0.0;
    if (!labels.empty())
      cv::minMaxLoc (labels, nullptr, &largest);
    return largest < 1.0;
  }

  std::string name_;
  DataFolder folder_;
  DatasetOptions options_;
};

} // namespace

Sequences
openCases (const std::string& path, const DatasetOptions& options)
{
  Sequences sequences;
  const auto isCase = [] (const std::string& folder) {
    for (const char* name : {"depth_0.png",
                             "depth_0.dpt",
                             "depth_0.pfm",
                             "depth_0.tiff",
                             "depth_0.tif",
                             "cloud_0.pcd"})
      if (isFile (inside (folder, name)))
        return true;
    return false;
  };
  for (const std::string& folder : foldersWhere (path, isCase))
    sequences.push_back (
        std::make_shared<CaseSequence> (nameBelow (path, folder), folder, options));
  return sequences;
}

} // namespace pcl_msf::io
