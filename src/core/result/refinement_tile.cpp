// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/result/refinement_tile.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include "core/base/opencv_threads.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl_msf {

namespace {

/** How far a tile's points go, and how they differ in that. */
struct Shift {
  cv::Point mean;
  int spread;
};

Shift
shiftOf (const cv::Mat& flow, const cv::Mat& mask, const cv::Rect& tile, int most)
{
  cv::Vec2d sum (0.0, 0.0);
  cv::Vec2f least (1e9f, 1e9f);
  cv::Vec2f largest (-1e9f, -1e9f);
  int count = 0;
  for (int y = tile.y; y < tile.br().y; ++y)
    for (int x = tile.x; x < tile.br().x; ++x)
      if (mask.ptr (y)[x] != 0) {
        const cv::Vec2f& f = flow.ptr<cv::Vec2f> (y)[x];
        sum += cv::Vec2d (f);
        ++count;
        for (int c = 0; c < 2; ++c) {
          least[c] = std::min (least[c], f[c]);
          largest[c] = std::max (largest[c], f[c]);
        }
      }
  const cv::Point mean (cvRound (sum[0] / count), cvRound (sum[1] / count));
  const float spread = std::max ({largest[0] - static_cast<float> (mean.x),
                                  static_cast<float> (mean.x) - least[0],
                                  largest[1] - static_cast<float> (mean.y),
                                  static_cast<float> (mean.y) - least[1]});
  return {mean, static_cast<int> (std::min (spread, static_cast<float> (most))) + 1};
}

/** The flow less a shift, with that of the nearest known pixel where it is unknown. */
cv::Mat
filled (const cv::Mat& flow, const cv::Point& shift)
{
  cv::Mat unknown (flow.size(), CV_8UC1);
  for (int y = 0; y < flow.rows; ++y)
    for (int x = 0; x < flow.cols; ++x)
      unknown.ptr (y)[x] = std::isfinite (flow.ptr<cv::Vec2f> (y)[x][0]) ? 0 : 255;
  cv::Mat distance;
  cv::Mat nearest;
  cv::distanceTransform (
      unknown, distance, nearest, cv::DIST_L2, 5, cv::DIST_LABEL_PIXEL);
  const cv::Vec2f less (static_cast<float> (shift.x), static_cast<float> (shift.y));
  std::vector<cv::Vec2f> of_label (flow.total() + 1);
  for (int y = 0; y < flow.rows; ++y)
    for (int x = 0; x < flow.cols; ++x)
      if (unknown.ptr (y)[x] == 0)
        of_label[nearest.ptr<int> (y)[x]] = flow.ptr<cv::Vec2f> (y)[x] - less;
  cv::Mat result (flow.size(), CV_32FC2);
  for (int y = 0; y < flow.rows; ++y)
    for (int x = 0; x < flow.cols; ++x)
      result.ptr<cv::Vec2f> (y)[x] = of_label[nearest.ptr<int> (y)[x]];
  return result;
}

/** A part of an image that may reach beyond it: the border is repeated. */
cv::Mat
partOf (const cv::Mat& image, const cv::Rect& part)
{
  const cv::Rect whole ({}, image.size());
  if ((part & whole) == part)
    return image (part);
  cv::Mat result (part.size(), image.type());
  for (int y = 0; y < part.height; ++y) {
    const float* row = image.ptr<float> (std::clamp (part.y + y, 0, image.rows - 1));
    for (int x = 0; x < part.width; ++x)
      result.ptr<float> (y)[x] = row[std::clamp (part.x + x, 0, image.cols - 1)];
  }
  return result;
}

/** The tile's images and what of them lies in the whole ones. */
class TileImages {
public:
  TileImages (const ComparedImages& images,
              const cv::Rect& part,
              const cv::Point& shift,
              double most)
  : reference_ (images.reference (part))
  , current_ (partOf (images.current, part + shift))
  , inside_ (cv::Point2f (-part.tl() - shift) - cv::Point2f (0.5f, 0.5f),
             cv::Size2f (images.current.size()))
  , most_ (static_cast<float> (most))
  {}

  /** Absolute difference of brightness where the flow leads. \param outside its value
   * where that is not in the image */
  cv::Mat
  residual (const cv::Mat& flow, float outside) const
  {
    cv::Mat place (flow.size(), CV_32FC2);
    for (int y = 0; y < flow.rows; ++y)
      for (int x = 0; x < flow.cols; ++x)
        place.ptr<cv::Vec2f> (y)[x] =
            flow.ptr<cv::Vec2f> (y)[x] +
            cv::Vec2f (static_cast<float> (x), static_cast<float> (y));
    cv::Mat value;
    cv::remap (current_, value, place, {}, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    for (int y = 0; y < flow.rows; ++y)
      for (int x = 0; x < flow.cols; ++x) {
        float& v = value.ptr<float> (y)[x];
        v = inside_.contains (cv::Point2f (place.ptr<cv::Vec2f> (y)[x]))
                ? std::min (std::abs (v - reference_.ptr<float> (y)[x]), most_)
                : outside;
      }
    return value;
  }

  cv::Mat
  meanResidual (const cv::Mat& flow, float outside, double window) const
  {
    cv::Mat result;
    cv::GaussianBlur (residual (flow, outside), result, {}, window);
    return result;
  }

  void
  refine (const RefinementTuning& tuning, cv::Mat& flow) const
  {
    constexpr double kGreyLevels = 255.0; // OpenCV's weights are for 8-bit images
    const auto refinement = cv::VariationalRefinement::create();
    refinement->setAlpha (static_cast<float> (tuning.smoothness));
    refinement->setDelta (static_cast<float> (tuning.brightness));
    refinement->setGamma (static_cast<float> (tuning.gradient));
    refinement->setFixedPointIterations (tuning.iterations);
    refinement->setSorIterations (tuning.relaxations);
    refinement->calc (reference_ * kGreyLevels, current_ * kGreyLevels, flow);
  }

private:
  const cv::Mat reference_;
  const cv::Mat current_;
  const cv::Rect2f inside_; ///< the current image
  const float most_;
};

} // namespace

RefinementTile
adaptTile (const ComparedImages& images,
           const cv::Mat& flow,
           const cv::Mat& mask,
           const cv::Rect& tile,
           const RefinementTuning& tuning)
{
  RefinementTile result;
  inThisThread ([&] {
    const Shift shift = shiftOf (flow, mask, tile, tuning.most_spread);
    const int around = tuning.margin + shift.spread;
    const cv::Size more (2 * around, 2 * around);
    const cv::Rect part =
        (tile - cv::Point (around, around) + more) & cv::Rect ({}, flow.size());
    const TileImages own (images, part, shift.mean, tuning.most_residual);
    const auto most = static_cast<float> (tuning.most_residual);
    cv::Mat adapted = filled (flow (part), shift.mean);
    result.own_residual = own.residual (adapted, 0.0f);
    if (!images.flow.empty()) {
      const cv::Mat other =
          images.flow (part) - cv::Scalar (shift.mean.x, shift.mean.y);
      cv::Mat before;
      cv::GaussianBlur (result.own_residual, before, {}, tuning.window);
      const cv::Mat after = own.meanResidual (other, most, tuning.window);
      other.copyTo (adapted,
                    after + images.noise < tuning.better * (before + images.noise));
    }
    own.refine (tuning, adapted);
    result.residual = own.residual (adapted, most);
    result.part = part;
    result.flow = adapted + cv::Scalar (shift.mean.x, shift.mean.y);
  });
  return result;
}

} // namespace pcl_msf
