// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/result/flow_refinement.h"

#include <opencv2/imgproc.hpp>

#include "core/base/opencv_threads.h"
#include "core/base/parallel_for.h"

#include <cmath>
#include <vector>

namespace pcl_msf {

namespace {

/** Per segment: is its motion known, and not that of a body that many points share? */
std::vector<char>
movesOtherwise (const SceneFlow& scene, double common_share)
{
  int all = 0;
  int common = 0;
  std::vector<char> known (scene.segments.size(), 0);
  std::vector<char> other (scene.segments.size(), 0);
  for (std::size_t k = 0; k < known.size(); ++k) {
    const SegmentMotion& segment = scene.segments[k];
    if (segment.status == MotionStatus::Undetermined)
      continue;
    const bool shared =
        segment.current_from_reference.parameters == scene.dominant_motion.parameters;
    all += segment.points;
    common += shared ? segment.points : 0;
    known[k] = 1;
    other[k] = shared ? 0 : 1;
  }
  return common < common_share * all ? known : other;
}

/** The tiles of an image in which there are points, as far as these reach. */
std::vector<cv::Rect>
tilesOf (const cv::Mat& mask, int side)
{
  std::vector<cv::Rect> tiles;
  for (int y = 0; y < mask.rows; y += side)
    for (int x = 0; x < mask.cols; x += side) {
      const cv::Rect tile = cv::Rect (x, y, side, side) & cv::Rect ({}, mask.size());
      if (const cv::Rect points = cv::boundingRect (mask (tile)); !points.empty())
        tiles.push_back (points + tile.tl());
    }
  return tiles;
}

/** Residuals of a segment's points, with the noise of each. */
struct SegmentResidual {
  double own{0.0};
  double adapted{0.0};
};

/** Calls f (y, x, place in the tile's images, segment) for a tile's points. */
template <typename F>
void
forEachPoint (const cv::Rect& tile,
              const cv::Rect& part,
              const cv::Mat& mask,
              const cv::Mat& labels,
              const F& f)
{
  for (int y = tile.y; y < tile.br().y; ++y)
    for (int x = tile.x; x < tile.br().x; ++x)
      if (mask.ptr (y)[x] != 0)
        f (y, x, cv::Point (x, y) - part.tl(), labels.ptr<int> (y)[x]);
}

/** Moves a point across the line of sight, to where its flow leads. */
void
moveTo (
    const cv::Vec2f& flow, const PinholeCamera& camera, int x, int y, SceneFlow& result)
{
  const cv::Vec3f& point = result.points.ptr<cv::Vec3f> (y)[x];
  cv::Vec3f& way = result.displacement.ptr<cv::Vec3f> (y)[x];
  const float z = point[2] + way[2];
  const double u = x + flow[0] - camera.cx;
  const double v = y + flow[1] - camera.cy;
  way[0] = static_cast<float> (u / camera.fx) * z - point[0];
  way[1] = static_cast<float> (v / camera.fy) * z - point[1];
  result.flow.ptr<cv::Vec2f> (y)[x] = flow;
}

} // namespace

cv::Mat
pointsToRefine (const SceneFlow& scene, const RefinementTuning& tuning, int threads)
{
  const std::vector<char> other = movesOtherwise (scene, tuning.common);
  cv::Mat mask (scene.labels.size(), CV_8UC1);
  const cv::Rect2f image ({}, cv::Size2f (mask.size()));
  const int count = parallelSum (threads, mask.rows, 32, [&] (int y) {
    const int* label = scene.labels.ptr<int> (y);
    const cv::Vec2f* flow = scene.flow.ptr<cv::Vec2f> (y);
    int in_row = 0;
    for (int x = 0; x < mask.cols; ++x) {
      const bool asked =
          label[x] >= 0 && other[label[x]] != 0 &&
          image.contains (cv::Point2f (static_cast<float> (x) + flow[x][0],
                                       static_cast<float> (y) + flow[x][1]));
      mask.ptr (y)[x] = asked ? 255 : 0;
      in_row += asked ? 1 : 0;
    }
    return in_row;
  });
  return count == 0 ? cv::Mat() : mask;
}

void
refineFlow (const ComparedImages& images,
            const PinholeCamera& camera,
            const cv::Mat& mask,
            const RefinementTuning& tuning,
            int threads,
            SceneFlow& result)
{
  const std::vector<cv::Rect> tiles = tilesOf (mask, tuning.tile);
  const int count = static_cast<int> (tiles.size());
  std::vector<RefinementTile> adapted (tiles.size());
  inThisThread ([&] { // once: of threads that enter by themselves, one waits for others
    parallelFor (threads, count, 1, [&] (int i) {
      adapted[i] = adaptTile (images, result.flow, mask, tiles[i], tuning);
    });
  });
  std::vector<SegmentResidual> sums (result.segments.size());
  for (int i = 0; i < count; ++i)
    forEachPoint (tiles[i],
                  adapted[i].part,
                  mask,
                  result.labels,
                  [&] (int, int, const cv::Point& at, int k) {
                    sums[k].own += adapted[i].own_residual.at<float> (at);
                    sums[k].own += images.noise;
                    sums[k].adapted += adapted[i].residual.at<float> (at);
                    sums[k].adapted += images.noise;
                  });
  parallelFor (threads, count, 1, [&] (int i) {
    forEachPoint (tiles[i],
                  adapted[i].part,
                  mask,
                  result.labels,
                  [&] (int y, int x, const cv::Point& at, int k) {
                    const cv::Vec2f& f = adapted[i].flow.at<cv::Vec2f> (at);
                    if (sums[k].adapted < tuning.clearly * sums[k].own &&
                        std::isfinite (f[0]) && std::isfinite (f[1]))
                      moveTo (f, camera, x, y, result);
                  });
  });
}

} // namespace pcl_msf
