// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/datasets/dataset_kinds.h"
#include "io/datasets/file_lists.h"
#include "io/datasets/frame_parts.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/cloud_files.h>

#include <mutex>
#include <utility>

namespace pcl_msf::io {

namespace {

class CloudSequence : public RgbdSequence {
public:
  CloudSequence (std::string name,
                 std::vector<std::string> files,
                 const CameraChoice& choice)
  : name_ (std::move (name)), files_ (std::move (files)), choice_ (choice)
  {}

  std::string
  name () const override
  {
    return name_;
  }

  int
  frames () const override
  {
    return static_cast<int> (files_.size());
  }

  RgbdImages
  frame (int k) const override
  {
    if (k < 0 || k >= frames())
      throw InvalidInput (noSuchFrame (name_, k, frames()));
    const std::string& file = files_[static_cast<std::size_t> (k)];
    RgbdImages images = readCloudImages (file, camera(), choice_.float_scale);
    requireSize (file, images.depth, choice_.size);
    return images;
  }

private:
  /** All clouds have one sensor; when nobody says which, the first one's points do. */
  PinholeCamera
  camera () const
  {
    if (choice_.camera.fx > 0.0)
      return choice_.camera;
    const std::lock_guard<std::mutex> lock (mutex_);
    if (!estimated_)
      estimated_ = readCloudImages (files_.front()).camera;
    return *estimated_;
  }

  std::string name_;
  std::vector<std::string> files_;
  CameraChoice choice_;
  mutable std::mutex mutex_;
  mutable std::optional<PinholeCamera> estimated_;
};

} // namespace

Sequences
openClouds (const std::string& path, const DatasetOptions& options)
{
  const auto isSequence = [] (const std::string& folder) {
    return !filesIn (folder, {".pcd"}).empty();
  };
  Sequences sequences;
  for (const std::string& folder : foldersWhere (path, isSequence))
    sequences.push_back (
        std::make_shared<CloudSequence> (nameBelow (path, folder),
                                         filesIn (folder, {".pcd"}),
                                         chooseCamera (folder, options, {})));
  return sequences;
}

} // namespace pcl_msf::io
