// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/result/dense_visibility.h"

#include <opencv2/imgproc.hpp>

#include "core/base/opencv_threads.h"
#include "core/base/order_statistics.h"
#include "core/base/parallel_for.h"
#include "core/data/surface_sample.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

/** Where a moved point lands and how it compares with what the frame shows there. */
struct Landing {
  bool inside{false};
  ImagePlace at;
  float expected{0.0f}; ///< inverse depth of the moved point, 1 / metres
  float shown{0.0f};    ///< of the frame's surface, 0 = none
};

/** Inverse depth on one surface, of the nearest pixel where surfaces meet. */
float
surfaceAt (const kernel::Image& image, const ImagePlace& at, float tolerance)
{
  const float u = std::clamp (at.u, 0.0f, static_cast<float> (image.width - 1));
  const float v = std::clamp (at.v, 0.0f, static_cast<float> (image.height - 1));
  const int u0 = std::min (static_cast<int> (u), image.width - 2);
  const int v0 = std::min (static_cast<int> (v), image.height - 2);
  const float* const top = image.texels + 2 * (v0 * image.width + u0) + 1;
  const float* const low = top + 2 * image.width;
  const auto [least, most] = std::minmax ({top[0], top[2], low[0], low[2]});
  if (!(least > 0.0f) || !(most - least < tolerance))
    return inverseDepthAt (image, {u, v});
  const float a = u - static_cast<float> (u0);
  const float b = v - static_cast<float> (v0);
  return bilinear (a, b, top[0], top[2], low[0], low[2]);
}

Landing
landingOf (const kernel::Image& image,
           const cv::Vec3f& moved,
           float tolerance,
           float most_share)
{
  Landing landing;
  if (!(moved[2] > 1e-3f)) // NaN, too
    return landing;
  landing.at = projectTo (image, {moved[0], moved[1], moved[2]});
  landing.inside = landing.at.u >= -0.5f && landing.at.v >= -0.5f &&
                   landing.at.u <= static_cast<float> (image.width) - 0.5f &&
                   landing.at.v <= static_cast<float> (image.height) - 0.5f;
  if (!landing.inside)
    return landing;
  landing.expected = 1.0f / moved[2];
  landing.shown = surfaceAt (
      image, landing.at, std::min (tolerance, most_share * landing.expected));
  return landing;
}

/** Where the result's motion takes the points. */
class Landings {
public:
  Landings (const SegmentPixels& pixels,
            const kernel::Image& image,
            const VisibilityTuning& tuning,
            const SceneFlow& result)
  : pixels_ (pixels)
  , image_ (image)
  , most_share_ (tuning.most_share)
  , points_ (result.points.ptr<cv::Vec3f>())
  , displacement_ (result.displacement.ptr<cv::Vec3f>())
  {}

  Landing
  of (int point) const
  {
    const int pixel = pixels_.pixel[point];
    return landingOf (image_,
                      points_[pixel] + displacement_[pixel],
                      pixels_.depth_tolerance[point],
                      most_share_);
  }

private:
  const SegmentPixels& pixels_;
  const kernel::Image image_;
  const float most_share_;
  const cv::Vec3f* const points_;
  const cv::Vec3f* const displacement_;
};

/** What the z-test's tolerances are too small by: noise that neighbouring pixels share
 * is in the residuals only, not in the frames' own estimates. */
float
widening (const Landings& landings,
          const SegmentPixels& pixels,
          const VisibilityTuning& tuning)
{
  const float most = tuning.most_widening;
  std::vector<float> sizes;
  const std::size_t count = pixels.pixel.size();
  const std::size_t step = 1 + count / tuning.samples;
  for (std::size_t i = 0; i < count; i += step) {
    const Landing landing = landings.of (static_cast<int> (i));
    const float size = std::abs (landing.shown - landing.expected);
    if (landing.shown > 0.0f && size <= most * pixels.depth_tolerance[i])
      sizes.push_back (size / pixels.depth_tolerance[i]);
  }
  if (sizes.empty())
    return 1.0f;
  return std::clamp (pixels.tolerance_sigmas * static_cast<float> (kMadToSigma) *
                         median (sizes),
                     1.0f,
                     most);
}

/** Measurements in a point's surroundings, and those of them that agree with it. */
struct Support {
  int measured{0};
  int agreeing{0};
};

/** \param inverse_depth of a pixel, <= 0 or NaN: none */
template <typename InverseDepth>
Support
supportOf (cv::Size size,
           cv::Point center,
           float expected,
           float tolerance,
           const InverseDepth& inverse_depth)
{
  Support support;
  const cv::Rect around (center.x - 1, center.y - 1, 3, 3);
  const cv::Rect inside = around & cv::Rect ({}, size);
  for (int y = inside.y; y < inside.y + inside.height; ++y)
    for (int x = inside.x; x < inside.x + inside.width; ++x) {
      const float w = inverse_depth (y, x);
      if (!(w > 0.0f))
        continue;
      ++support.measured;
      support.agreeing += std::abs (w - expected) <= tolerance ? 1 : 0;
    }
  return support;
}

/** Least and greatest inverse depth of the 3 x 3 pixels around each, as far as they are
 * in the image. */
class Surroundings {
public:
  Surroundings (const kernel::Image& image, int threads)
  {
    // OpenCV takes no const data; nothing writes to it.
    const cv::Mat texels (
        image.height, image.width, CV_32FC2, const_cast<float*> (image.texels));
    cv::Mat inverse_depth;
    cv::extractChannel (texels, inverse_depth, 1);
    parallelFor (threads, 2, 1, [&] (int i) {
      inThisThread ([&] {
        if (i == 0)
          cv::erode (inverse_depth, least_, cv::Mat());
        else
          cv::dilate (inverse_depth, greatest_, cv::Mat());
      });
    });
  }

  /** Are all of them measured and near a value? */
  bool
  agree (const cv::Point& at, float expected, float tolerance) const
  {
    const float least = least_.ptr<float> (at.y)[at.x];
    return least > 0.0f && expected - least <= tolerance &&
           greatest_.ptr<float> (at.y)[at.x] - expected <= tolerance;
  }

private:
  cv::Mat least_, greatest_;
};

/** Do enough of the frame's measurements around a landing agree with the point? As
 * many as in the reference are enough, as for a point that stands alone there.
 * \param pixel of the point in the reference */
bool
liesOnSurface (const kernel::Image& image,
               const Surroundings& surroundings,
               const Landing& landing,
               float tolerance,
               int least,
               const cv::Mat& points,
               int pixel)
{
  const cv::Point at (
      std::min (static_cast<int> (landing.at.u + 0.5f), image.width - 1),
      std::min (static_cast<int> (landing.at.v + 0.5f), image.height - 1));
  if (surroundings.agree (at, landing.expected, tolerance))
    return true;
  const Support there = supportOf (
      {image.width, image.height}, at, landing.expected, tolerance, [&] (int y, int x) {
        return image.texels[2 * (y * image.width + x) + 1];
      });
  const int required = std::min (least, there.measured);
  if (there.agreeing >= required)
    return true;
  const cv::Point own (pixel % points.cols, pixel / points.cols);
  const auto before = [&] (int y, int x) {
    return 1.0f / points.at<cv::Vec3f> (y, x)[2];
  };
  const Support here =
      supportOf (points.size(), own, before (own.y, own.x), tolerance, before);
  return there.agreeing >= std::min (required, here.agreeing);
}

/** \param pixel of the point in the reference */
Visibility
visibilityOf (const kernel::Image& image,
              const Surroundings& surroundings,
              const Landing& landing,
              float tolerance,
              const VisibilityTuning& tuning,
              const cv::Mat& points,
              int pixel)
{
  if (!landing.inside)
    return Visibility::OutOfView;
  if (!(landing.shown > 0.0f))
    return Visibility::Unknown;
  const float within = std::min (tolerance, tuning.most_share * landing.expected);
  const float behind = landing.shown - landing.expected;
  if (behind > within)
    return Visibility::Occluded;
  if (behind < -within)
    return Visibility::Unknown;
  return liesOnSurface (
             image, surroundings, landing, within, tuning.surface, points, pixel)
             ? Visibility::Visible
             : Visibility::Unknown;
}

} // namespace

void
fillVisibility (const SegmentPixels& p,
                const kernel::Image& image,
                const VisibilityTuning& tuning,
                int threads,
                SceneFlow& result)
{
  result.visibility = cv::Mat (
      result.labels.size(), CV_8UC1, cv::Scalar (pixelValue (Visibility::NoDepth)));
  const Landings landings (p, image, tuning, result);
  const float wider = widening (landings, p, tuning);
  const Surroundings surroundings (image, threads);
  parallelFor (threads, p.segments(), 8, [&] (int k) {
    SegmentMotion& segment = result.segments[k];
    const bool known = segment.status != MotionStatus::Undetermined;
    segment.points = p.pixels (k);
    segment.visible_points = 0;
    for (int i = p.begin[k]; i < p.begin[k + 1]; ++i) {
      const Visibility seen = known ? visibilityOf (image,
                                                    surroundings,
                                                    landings.of (i),
                                                    wider * p.depth_tolerance[i],
                                                    tuning,
                                                    result.points,
                                                    p.pixel[i])
                                    : Visibility::Unknown;
      result.visibility.ptr<unsigned char>()[p.pixel[i]] = pixelValue (seen);
      segment.visible_points += seen == Visibility::Visible ? p.pixels_per_point[k] : 0;
    }
  });
}

} // namespace pcl_msf
