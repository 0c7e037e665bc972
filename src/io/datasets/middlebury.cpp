// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/datasets/dataset_kinds.h"
#include "io/datasets/file_lists.h"
#include "io/datasets/frame_parts.h"
#include "io/datasets/listed_sequence.h"
#include "io/datasets/middlebury_files.h"
#include "io/datasets/truth_parts.h"

#include <cmath>
#include <limits>
#include <utility>

namespace pcl_msf::io {

namespace {

/** Flow along rows: `sign` times the disparity. */
cv::Mat
flowFromDisparity (const cv::Mat& disparity, float sign)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  cv::Mat flow (disparity.size(), CV_32FC2, cv::Scalar (nan, nan));
  for (int row = 0; row < flow.rows; ++row)
    for (int col = 0; col < flow.cols; ++col)
      if (const float d = disparity.at<float> (row, col); std::isfinite (d))
        flow.at<cv::Vec2f> (row, col) = {sign * d, 0.0F};
  return flow;
}

/** Pixels whose partner in the other view has the same disparity, to one pixel. */
cv::Mat
consistent (const cv::Mat& flow, const cv::Mat& disparity, const cv::Mat& other)
{
  cv::Mat seen (flow.size(), CV_8UC1, cv::Scalar (0));
  for (int row = 0; row < flow.rows; ++row)
    for (int col = 0; col < flow.cols; ++col) {
      const float d = disparity.at<float> (row, col);
      if (!std::isfinite (d))
        continue;
      const auto partner = static_cast<int> (
          std::lround (static_cast<float> (col) + flow.at<cv::Vec2f> (row, col)[0]));
      if (partner >= 0 && partner < other.cols &&
          std::abs (other.at<float> (row, partner) - d) <= 1.0F)
        seen.at<unsigned char> (row, col) = 255;
    }
  return seen;
}

/** \brief The left view, then the right one: a camera that moves by the baseline. */
class MiddleburySequence : public ListedSequence {
public:
  MiddleburySequence (std::string name,
                      MiddleburyPair pair,
                      std::vector<FrameFiles> files)
  : ListedSequence (std::move (name), std::move (files), 1.0), pair_ (std::move (pair))
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
    if (from == to)
      return truth;
    const auto a = static_cast<std::size_t> (from), b = static_cast<std::size_t> (to);
    const FrameFiles& first = files (from);
    const FrameFiles& second = files (to);
    const cv::Mat disparity = readMiddleburyDisparity (pair_, a);
    const cv::Mat other = readMiddleburyDisparity (pair_, b);
    requireSize (first.depth, disparity, imageSize (from));
    requireSize (second.depth, other, disparity.size());
    truth.flow = flowFromDisparity (disparity, from == 0 ? -1.0F : 1.0F);
    truth.visible = consistent (truth.flow, disparity, other);
    const cv::Mat z = depth (first);
    truth.scene_flow = sceneFlowFrom (z, truth.flow, z, first.camera, second.camera);
    truth.rigid = second.world_from_camera->inverse() * *first.world_from_camera;
    return truth;
  }

protected:
  cv::Mat
  depth (const FrameFiles& files) const override
  {
    const std::size_t view = files.depth == pair_.disparity[0] ? 0 : 1;
    return depthFromDisparity (readMiddleburyDisparity (pair_, view),
                               files.camera.fx * pair_.baseline,
                               pair_.offset);
  }

private:
  MiddleburyPair pair_;
};

std::shared_ptr<const RgbdSequence>
openOne (const std::string& name,
         const std::string& folder,
         const DatasetOptions& options)
{
  MiddleburyPair pair = findMiddlebury (folder);
  if (options.camera) {
    pair.camera.fill (*options.camera);
    pair.camera[1].cx += pair.offset;
  }
  std::vector<FrameFiles> files (2);
  for (std::size_t view = 0; view < 2; ++view) {
    files[view].color = pair.color[view];
    files[view].depth = pair.disparity[view];
    files[view].camera = pair.camera[view];
    files[view].world_from_camera =
        RigidPose{{0.0, 0.0, 0.0, view == 0 ? 0.0 : pair.baseline, 0.0, 0.0}};
  }
  return std::make_shared<MiddleburySequence> (name, pair, std::move (files));
}

} // namespace

Sequences
openMiddlebury (const std::string& path, const DatasetOptions& options)
{
  Sequences sequences;
  for (const std::string& folder : foldersWhere (path, isMiddlebury))
    sequences.push_back (openOne (nameBelow (path, folder), folder, options));
  return sequences;
}

} // namespace pcl_msf::io
