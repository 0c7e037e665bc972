// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/datasets/dataset_kinds.h"
#include "io/datasets/file_lists.h"
#include "io/datasets/frame_parts.h"
#include "io/datasets/kitti_files.h"
#include "io/datasets/listed_sequence.h"
#include "io/datasets/truth_parts.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/images.h>

#include <utility>

namespace pcl_msf::io {

namespace {

/** \brief Frames 10 and 11 of one scene. Their depth is from dense disparities of the
 * user's: the data set's own are sparse, and its disp_occ_1 lies at the first frame's
 * pixels, so that it is truth and no input. */
class KittiSequence : public ListedSequence {
public:
  KittiSequence (std::string training,
                 const std::string& scene,
                 std::vector<FrameFiles> files,
                 double baseline)
  : ListedSequence (scene, std::move (files), 1.0)
  , training_ (std::move (training))
  , first_ (scene + "_10.png")
  , baseline_ (baseline)
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
    if (from != 0 || to != 1)
      return truth;
    const cv::Size size = imageSize (0);
    const auto fits = [&size] (const std::string& path, const cv::Mat& image) {
      requireSize (path, image, size);
      return image;
    };
    if (const std::string path = own ("flow_occ"); isFile (path))
      truth.flow = fits (path, readKittiFlow (path));
    if (const std::string path = own ("flow_noc"); isFile (path))
      truth.visible = known (fits (path, readKittiFlow (path)));
    if (const std::string path = own ("obj_map"); isFile (path))
      truth.labels = fits (path, readLabels (path));
    const std::string before = own ("disp_occ_0"), after = own ("disp_occ_1");
    if (truth.flow.empty() || !isFile (before) || !isFile (after))
      return truth;
    const double fb = files (0).camera.fx * baseline_;
    truth.scene_flow = sceneFlowFrom (
        depthFromDisparity (fits (before, readKittiDisparity (before)), fb),
        truth.flow,
        depthFromDisparity (fits (after, readKittiDisparity (after)), fb),
        files (0).camera,
        files (1).camera);
    return truth;
  }

protected:
  cv::Mat
  depth (const FrameFiles& files) const override
  {
    if (!isFile (files.depth))
      throw IoError (files.depth +
                     ": disparity: no such file; the data set has no dense depth, so "
                     "put disparities of both frames (16-bit PNG, 256 a pixel, or "
                     ".pfm) into disp_0 and disp_1 beside image_2");
    return depthFromDisparity (readKittiDisparity (files.depth),
                               files.camera.fx * baseline_);
  }

private:
  std::string
  own (const char* kind) const
  {
    return inside (training_, std::string (kind) + "/" + first_);
  }

  static cv::Mat
  known (const cv::Mat& flow)
  {
    cv::Mat u;
    cv::extractChannel (flow, u, 0);
    return u == u;
  }

  std::string training_;
  std::string first_;
  double baseline_;
};

/** The user's disparities of frame 10 or 11, at that frame's own pixels. */
std::string
denseDisparity (const std::string& training, const std::string& scene, int k)
{
  const std::string stem = scene + (k == 0 ? "_10" : "_11");
  const std::string usual = k == 0 ? "disp_0/" : "disp_1/";
  for (const std::string& name : {usual + stem + ".png",
                                  usual + stem + ".pfm",
                                  "disp_0/" + stem + ".png",
                                  "disp_0/" + stem + ".pfm"})
    if (isFile (inside (training, name)))
      return inside (training, name);
  return inside (training, usual + stem + ".png");
}

std::shared_ptr<const RgbdSequence>
openOne (const std::string& training,
         const std::string& scene,
         const DatasetOptions& options)
{
  const KittiCamera calibration =
      readKittiCamera (inside (training, "calib_cam_to_cam/" + scene + ".txt"));
  std::vector<FrameFiles> files (2);
  for (int k = 0; k < 2; ++k) {
    FrameFiles& frame = files[static_cast<std::size_t> (k)];
    frame.color =
        inside (training, "image_2/" + scene + (k == 0 ? "_10" : "_11") + ".png");
    frame.depth = denseDisparity (training, scene, k);
    frame.camera = options.camera.value_or (calibration.camera);
  }
  return std::make_shared<KittiSequence> (
      training, scene, std::move (files), calibration.baseline);
}

} // namespace

Sequences
openKitti2015 (const std::string& path, const DatasetOptions& options)
{
  const auto isTraining = [] (const std::string& folder) {
    return isFolder (inside (folder, "image_2")) &&
           (isFolder (inside (folder, "calib_cam_to_cam")) ||
            isFolder (inside (folder, "flow_occ")) ||
            isFolder (inside (folder, "disp_occ_0")));
  };
  const std::string end = "_10.png";
  Sequences sequences;
  for (const std::string& training : foldersWhere (path, isTraining))
    for (const std::string& image : filesIn (inside (training, "image_2"), {".png"})) {
      const std::string name = lastName (image);
      if (name.size() > end.size() &&
          name.compare (name.size() - end.size(), end.size(), end) == 0)
        sequences.push_back (
            openOne (training, name.substr (0, name.size() - end.size()), options));
    }
  return sequences;
}

} // namespace pcl_msf::io
