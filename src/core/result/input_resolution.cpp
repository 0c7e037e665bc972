// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/result/input_resolution.h"

#include "core/base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace pcl_msf {

namespace {

/** A frame's pixel beside a pixel of the input. */
struct Neighbor {
  int x, y;
  float weight;     ///< of bilinear interpolation
  float difference; ///< of the inverse depth
};

/** Mean way of some pixels, and where they are. */
struct MeanWay {
  Eigen::Vector3f way = Eigen::Vector3f::Zero();
  Eigen::Vector3f point = Eigen::Vector3f::Zero();
  float weights{0.0f};

  void
  add (float weight, const cv::Vec3f& d, const cv::Vec3f& p)
  {
    if (std::isnan (d[0]))
      return;
    way += weight * Eigen::Vector3f (d[0], d[1], d[2]);
    point += weight * Eigen::Vector3f (p[0], p[1], p[2]);
    weights += weight;
  }

  /** Of another point, NaN where nothing is known. \param turn rotation less identity
   */
  Eigen::Vector3f
  at (const Eigen::Vector3f& p, const Eigen::Matrix3f& turn) const
  {
    const float share = 1.0f / weights;
    return share * way + turn * (p - share * point);
  }
};

/** A result's images, row by row. */
struct ResultRow {
  int* label;
  unsigned char* visibility;
  cv::Vec3f* point;
  cv::Vec3f* way;
  cv::Vec2f* flow;
  float* flow_deviation;
  float* deviation;

  ResultRow (SceneFlow& scene, int y)
  : label (scene.labels.ptr<int> (y))
  , visibility (scene.visibility.ptr (y))
  , point (scene.points.ptr<cv::Vec3f> (y))
  , way (scene.displacement.ptr<cv::Vec3f> (y))
  , flow (scene.flow.ptr<cv::Vec2f> (y))
  , flow_deviation (scene.flow_deviation.ptr<float> (y))
  , deviation (scene.displacement_deviation.ptr<float> (y))
  {}

  void
  forget (int columns) const
  {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    std::fill_n (label, columns, -1);
    std::fill_n (visibility, columns, pixelValue (Visibility::NoDepth));
    std::fill_n (point, columns, cv::Vec3f (kNan, kNan, kNan));
    std::fill_n (way, columns, cv::Vec3f (kNan, kNan, kNan));
    std::fill_n (flow, columns, cv::Vec2f (kNan, kNan));
    std::fill_n (flow_deviation, columns, kNan);
    std::fill_n (deviation, columns, kNan);
  }
};

/** Fills the input's images from those of the frame. */
class InputFiller {
public:
  InputFiller (const RgbdFrame& reference,
               const PinholeCamera& camera,
               const FrameTuning& tuning,
               SceneFlow& coarse,
               SceneFlow& fine)
  : frame_depth_ (reference.levels()[0].inverse_depth)
  , depth_ (reference.inputInverseDepth())
  , own_ (reference.inputCamera())
  , current_ (camera)
  , level_ (reference.finestLevel())
  , noise_ (tuning.same_sigmas * static_cast<float> (reference.inverseDepthNoise()))
  , same_surface_ (tuning.same_surface)
  , coarse_ (coarse)
  , fine_ (fine)
  {
    for (const SegmentMotion& segment : coarse.segments)
      turns_.emplace_back (
          (segment.current_from_reference.rotation() - Eigen::Matrix3d::Identity())
              .cast<float>());
    fine.camera = own_;
    fine.labels.create (depth_.size(), CV_32SC1);
    fine.visibility.create (depth_.size(), CV_8UC1);
    fine.points.create (depth_.size(), CV_32FC3);
    fine.displacement.create (depth_.size(), CV_32FC3);
    fine.flow.create (depth_.size(), CV_32FC2);
    fine.flow_deviation.create (depth_.size(), CV_32FC1);
    fine.displacement_deviation.create (depth_.size(), CV_32FC1);
  }

  void
  fillRow (int y) const
  {
    const ResultRow row (fine_, y);
    row.forget (depth_.cols);
    const float* w = depth_.ptr<float> (y);
    const auto down = static_cast<float> ((y - own_.cy) / own_.fy);
    for (int x = 0; x < depth_.cols; ++x)
      if (w[x] > 0.0f) {
        const float z = 1.0f / w[x];
        const auto across = static_cast<float> ((x - own_.cx) / own_.fx);
        fill (x, y, {across * z, down * z, z}, row);
      }
  }

private:
  /** Calls f for the frame's labelled pixels at most `reach` - 1 beyond the cell that
   * holds a pixel of the input. */
  template <typename F>
  void
  forEachAround (int x, int y, int reach, const F& f) const
  {
    const float share = 1.0f / static_cast<float> (1 << level_);
    const float w = depth_.ptr<float> (y)[x];
    const int left = x >> level_;
    const int top = y >> level_;
    const int right = std::min (frame_depth_.cols - 1, left + reach);
    const int bottom = std::min (frame_depth_.rows - 1, top + reach);
    for (int j = std::max (0, top + 1 - reach); j <= bottom; ++j) {
      const int* label = coarse_.labels.ptr<int> (j);
      const float* depth = frame_depth_.ptr<float> (j);
      const float v =
          1.0f - std::abs (share * static_cast<float> (y) - static_cast<float> (j));
      for (int i = std::max (0, left + 1 - reach); i <= right; ++i)
        if (label[i] >= 0) {
          const float u =
              1.0f - std::abs (share * static_cast<float> (x) - static_cast<float> (i));
          f (Neighbor{i, j, u * v, std::abs (depth[i] - w)});
        }
    }
  }

  void
  fill (int x, int y, const Eigen::Vector3f& point, const ResultRow& row) const
  {
    row.point[x] = {point.x(), point.y(), point.z()};
    const float tolerance = std::max (noise_, same_surface_ / point.z());
    MeanWay mean;
    Neighbor lead{-1, -1, 0.0f, 0.0f};
    const auto add = [&] (const Neighbor& n, float weight) {
      mean.add (weight,
                coarse_.displacement.ptr<cv::Vec3f> (n.y)[n.x],
                coarse_.points.ptr<cv::Vec3f> (n.y)[n.x]);
    };
    forEachAround (x, y, 1, [&] (const Neighbor& n) {
      if (n.weight <= 0.0f || n.difference > tolerance)
        return;
      add (n, n.weight);
      if (n.weight > lead.weight)
        lead = n;
    });
    if (lead.x < 0) {
      forEachAround (x, y, kFar, [&] (const Neighbor& n) {
        if (lead.x < 0 || n.difference < lead.difference)
          lead = n;
      });
      if (lead.x < 0)
        return;
      add (lead, 1.0f);
    }
    const ResultRow there (coarse_, lead.y);
    const int label = row.label[x] = there.label[lead.x];
    row.visibility[x] = there.visibility[lead.x];
    row.flow_deviation[x] =
        static_cast<float> (1 << level_) * there.flow_deviation[lead.x];
    row.deviation[x] = there.deviation[lead.x];
    move (x, y, point, mean.at (point, turns_[label]), row);
  }

  void
  move (int x,
        int y,
        const Eigen::Vector3f& point,
        const Eigen::Vector3f& way,
        const ResultRow& row) const
  {
    row.way[x] = {way.x(), way.y(), way.z()};
    const Eigen::Vector3f moved = point + way;
    if (!(moved.z() > 1e-3f))
      return;
    const double w = 1.0 / moved.z();
    row.flow[x] = {static_cast<float> (current_.fx * moved.x() * w + current_.cx - x),
                   static_cast<float> (current_.fy * moved.y() * w + current_.cy - y)};
  }

  static constexpr int kFar = 3; ///< frame pixels

  const cv::Mat frame_depth_;
  const cv::Mat depth_;
  const PinholeCamera own_;
  const PinholeCamera current_;
  const int level_;
  const float noise_;
  const float same_surface_;
  std::vector<Eigen::Matrix3f> turns_; ///< per segment, rotation less identity
  SceneFlow& coarse_;
  SceneFlow& fine_;
};

void
countPoints (SceneFlow& scene)
{
  for (SegmentMotion& segment : scene.segments)
    segment.points = segment.visible_points = 0;
  for (int y = 0; y < scene.labels.rows; ++y)
    for (int x = 0; x < scene.labels.cols; ++x)
      if (const int k = scene.labels.ptr<int> (y)[x]; k >= 0) {
        ++scene.segments[k].points;
        if (scene.visibility.ptr (y)[x] == Visibility::Visible)
          ++scene.segments[k].visible_points;
      }
}

} // namespace

void
carryToInput (const RgbdFrame& reference,
              const PinholeCamera& camera,
              const FrameTuning& tuning,
              int threads,
              SceneFlow& result)
{
  SceneFlow fine;
  const InputFiller filler (reference, camera, tuning, result, fine);
  parallelFor (threads, reference.inputInverseDepth().rows, 16, [&] (int y) {
    filler.fillRow (y);
  });
  result.camera = fine.camera;
  std::swap (result.labels, fine.labels);
  std::swap (result.visibility, fine.visibility);
  std::swap (result.points, fine.points);
  std::swap (result.displacement, fine.displacement);
  std::swap (result.flow, fine.flow);
  std::swap (result.flow_deviation, fine.flow_deviation);
  std::swap (result.displacement_deviation, fine.displacement_deviation);
  countPoints (result);
}

} // namespace pcl_msf
