// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Butler et al., "A Naturalistic Open Source Movie for Optical Flow Evaluation", ECCV
// 2012, and the formats of its depth and camera motion release.
#include "io/datasets/dataset_kinds.h"
#include "io/datasets/file_lists.h"
#include "io/datasets/frame_parts.h"
#include "io/datasets/listed_sequence.h"
#include "io/datasets/truth_parts.h"
#include <pcl_msf/io/float_files.h>
#include <pcl_msf/io/images.h>

#include <filesystem>
#include <utility>

namespace pcl_msf::io {

namespace {

/** Folders of one sequence: training/KIND/NAME. */
struct SintelPlace {
  std::string training;
  std::string name;

  std::string
  file (const char* kind, const std::string& frame) const
  {
    return inside (training, std::string (kind) + "/" + name + "/" + frame);
  }
};

class SintelSequence : public ListedSequence {
public:
  SintelSequence (std::string name, SintelPlace place, std::vector<FrameFiles> files)
  : ListedSequence (std::move (name), std::move (files), 1.0)
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
    MotionTruth truth;
    const std::string stem = std::filesystem::path (files (from).color).stem().string();
    const std::string flow = place_.file ("flow", stem + ".flo");
    if (!follows (from, to) || !isFile (flow))
      return truth;
    truth.flow = readFlow (flow);
    requireSize (flow, truth.flow, imageSize (from));
    truth.visible = staysInside (truth.flow);
    for (const char* kind : {"occlusions", "invalid"}) {
      const std::string mask = place_.file (kind, stem + ".png");
      if (!isFile (mask))
        continue;
      const cv::Mat hidden = readMask (mask);
      requireSize (mask, hidden, truth.flow.size());
      truth.visible.setTo (0, hidden);
    }
    if (!isFile (place_.file ("occlusions", stem + ".png")))
      truth.visible.release();
    return truth;
  }

private:
  SintelPlace place_;
};

std::shared_ptr<const RgbdSequence>
openOne (const std::string& name,
         const SintelPlace& place,
         const std::vector<std::string>& images,
         const DatasetOptions& options)
{
  const bool has_cameras = isFolder (place.file ("camdata_left", ""));
  std::vector<FrameFiles> files;
  for (const std::string& image : images) {
    const std::string stem = std::filesystem::path (image).stem().string();
    FrameFiles frame;
    frame.color = image;
    frame.number = trailingNumber (image);
    frame.depth = place.file ("depth", stem + ".dpt");
    if (has_cameras || !options.camera) {
      RigidPose camera_from_world;
      frame.camera =
          readCam (place.file ("camdata_left", stem + ".cam"), camera_from_world);
      frame.world_from_camera = camera_from_world.inverse();
    }
    frame.camera = options.camera.value_or (frame.camera);
    files.push_back (frame);
  }
  return std::make_shared<SintelSequence> (name, place, std::move (files));
}

} // namespace

Sequences
openSintel (const std::string& path, const DatasetOptions& options)
{
  // A path into one of the renderings chooses that one.
  std::string pass = toString (options.pass);
  for (const std::string& folder : {path, parentFolder (path)})
    if (lastName (folder) == "clean" || lastName (folder) == "final")
      pass = lastName (folder);
  const auto isSequence = [&pass] (const std::string& folder) {
    const std::string above = parentFolder (folder);
    const std::string top = parentFolder (above);
    const bool has_truth =
        isFolder (inside (top, "depth")) || isFolder (inside (top, "camdata_left"));
    return lastName (above) == pass && has_truth;
  };
  Sequences sequences;
  for (const std::string& folder : foldersWhere (path, isSequence)) {
    const std::vector<std::string> images = filesIn (folder, {".png"});
    const SintelPlace place{parentFolder (parentFolder (folder)), lastName (folder)};
    if (!images.empty())
      sequences.push_back (openOne (place.name, place, images, options));
  }
  return sequences;
}

} // namespace pcl_msf::io
