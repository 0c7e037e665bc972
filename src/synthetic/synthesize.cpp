// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/parallel_for.h"
#include <pcl_msf/errors.h>
#include <synthetic/color_camera.h>
#include <synthetic/color_renderer.h>
#include <synthetic/lattice_noise.h>
#include <synthetic/sensor_model.h>
#include <synthetic/truth.h>

#include <algorithm>
#include <cmath>

namespace pcl_msf::synthetic {
namespace {

constexpr int shutter_samples = 7;
constexpr double shutter = 0.5; ///< share of the frame interval
constexpr int rows_at_once = 4; ///< of a rolling shutter

/** The phase per frame that gives the wanted image motion, found on a small image. */
double
rateFor (const SceneModel& scene,
         const PinholeCamera& camera,
         const SequenceOptions& options,
         int threads)
{
  const double wanted = options.motion_pixels > 0.0          ? options.motion_pixels
                        : options.motion == MotionSize::Easy ? 4.0
                                                             : 22.0;
  constexpr int width = 80;
  const double scale = static_cast<double> (width) / options.width;
  const cv::Size size (width, std::max (1, static_cast<int> (scale * options.height)));
  // Pixel centres keep their places relative to the image's borders.
  const PinholeCamera small{scale * camera.fx,
                            scale * camera.fy,
                            scale * (camera.cx + 0.5) - 0.5,
                            scale * (camera.cy + 0.5) - 0.5};
  const FrameView start (scene, small, size, 0.0);
  const std::vector<ViewHit> hits = castPixels (start, threads);
  double rate = wanted / 4.0, best_rate = rate, least_error = 1e9;
  for (int i = 0; i < 8; ++i) {
    const FrameView next (scene, small, size, rate);
    const double motion = meanMotion (scene, start, hits, next) * 640.0 / width;
    const double error = std::abs (motion - wanted);
    if (error < least_error) {
      least_error = error;
      best_rate = rate;
    }
    const double factor = wanted / std::max (motion, 1e-9);
    rate = std::clamp (rate * std::clamp (factor, 0.5, 2.0), 1e-4, 15.0);
  }
  return best_rate;
}

/** A scene with what its frames share, while it is drawn. */
class SequenceRenderer {
public:
  explicit SequenceRenderer (const SequenceOptions& options)
  : options_ (options)
  , threads_ (threadCount (options.threads))
  , scene_ (buildScene (options.scene, options.seed))
  , camera_ (options.usedCamera())
  , renderer_ (scene_, options.seed, options.supersampling)
  , rate_ (rateFor (scene_, camera_, options, threads_))
  {}

  SyntheticSequence
  draw () const;

private:
  FrameView
  viewAt (double frame) const
  {
    return {scene_, camera_, {options_.width, options_.height}, rate_ * frame};
  }

  ImageViews
  imageAt (double frame, const Lens& lens) const;

  cv::Mat
  colorAt (double frame,
           const ImageViews& views,
           const std::vector<ViewHit>& hits) const;

  SyntheticFrame
  frameAt (int frame, const FrameView& view, const std::vector<ViewHit>& hits) const;

  void
  addPoses (int frame, SyntheticSequence& sequence) const;

  SequenceOptions options_;
  int threads_;
  SceneModel scene_;
  PinholeCamera camera_;
  ColorRenderer renderer_;
  double rate_; ///< phase per frame
};

/** What the camera's rows see while it reads them. */
ImageViews
SequenceRenderer::imageAt (double frame, const Lens& lens) const
{
  const cv::Size size (options_.width, options_.height);
  const double share = options_.effects.rolling_shutter;
  const int count = share > 0.0 ? (size.height + rows_at_once - 1) / rows_at_once : 1;
  std::vector<std::unique_ptr<const FrameView>> views (count);
  parallelFor (threads_, count, 1, [&] (int i) {
    const double time = share * ((i + 0.5) / count - 0.5);
    views[i] = std::make_unique<FrameView> (
        scene_, camera_, size, rate_ * (frame + time), lens);
  });
  return ImageViews (std::move (views));
}

cv::Mat
SequenceRenderer::colorAt (double frame,
                           const ImageViews& views,
                           const std::vector<ViewHit>& hits) const
{
  if (!options_.motion_blur)
    return renderer_.render (views, hits, threads_);
  cv::Mat sum = cv::Mat::zeros (views.size(), CV_32FC3);
  for (int i = 0; i < shutter_samples; ++i) {
    const double time = shutter * (i / (shutter_samples - 1.0) - 0.5);
    const ImageViews moment = imageAt (frame + time, {options_.effects.distortion});
    sum += renderer_.render (moment, castPixels (moment, threads_), threads_);
  }
  return sum / shutter_samples;
}

/** \param view ideal, with its hits */
SyntheticFrame
SequenceRenderer::frameAt (int frame,
                           const FrameView& view,
                           const std::vector<ViewHit>& hits) const
{
  const CameraEffects& effects = options_.effects;
  const Lens color_lens{effects.distortion};
  const Lens depth_lens{effects.distortion,
                        {effects.depth_shift_x, effects.depth_shift_y}};
  const bool exact = color_lens.isNone() && effects.rolling_shutter == 0.0;
  const bool together =
      effects.depth_delay == 0.0 && depth_lens.shift == Eigen::Vector2d::Zero();
  const ImageViews color_views =
      exact ? ImageViews (view) : imageAt (frame, color_lens);
  const ImageViews depth_views =
      exact && together ? ImageViews (view)
                        : imageAt (frame + effects.depth_delay, depth_lens);
  const std::vector<ViewHit> color_hits =
      exact ? hits : castPixels (color_views, threads_);
  const std::vector<ViewHit> depth_hits =
      together ? color_hits : castPixels (depth_views, threads_);
  SyntheticFrame result;
  result.depth = depthOf (view.size(), depth_hits);
  cv::Mat color = colorAt (frame, color_views, color_hits);
  const std::uint64_t device = 65537ULL * options_.noise_seed.value_or (options_.seed);
  const std::uint64_t key = device + frame;
  applyDepthSensor (options_.sensor,
                    {depth_views, depth_hits, color, mixed (device), key, threads_},
                    result.depth);
  applyColorCamera (options_.sensor, effects, key, threads_, color);
  color.convertTo (result.color, CV_8UC3);
  return result;
}

void
SequenceRenderer::addPoses (int frame, SyntheticSequence& sequence) const
{
  const double phase = rate_ * frame;
  const Isometry world_from_frame = scene_.world_from_camera (phase);
  const Isometry world_from_frame0 = scene_.world_from_camera (0.0);
  const auto pose = [] (const Isometry& t) {
    return RigidPose::fromMatrix (Eigen::Matrix3d (t.linear()), t.translation());
  };
  sequence.frame0_from_framek.push_back (
      pose (world_from_frame0.inverse() * world_from_frame));
  for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
    const Body& body = scene_.bodies[b];
    sequence.bodies[b].framek_from_frame0.push_back (
        pose (world_from_frame.inverse() * body.world_from_body (phase) *
              body.world_from_body (0.0).inverse() * world_from_frame0));
  }
}

SyntheticSequence
SequenceRenderer::draw() const
{
  SyntheticSequence sequence;
  sequence.options = options_;
  sequence.camera = camera_;
  for (const Body& body : scene_.bodies)
    sequence.bodies.push_back ({body.name, body.rigid, {}});
  const FrameView first = viewAt (0);
  const std::vector<ViewHit> first_hits = castPixels (first, threads_);
  sequence.labels = labelsOf (scene_, first, first_hits);
  for (int k = 0; k < options_.frames; ++k) {
    const FrameView view = viewAt (k);
    const std::vector<ViewHit> hits = k > 0 ? castPixels (view, threads_) : first_hits;
    sequence.frames.push_back (frameAt (k, view, hits));
    sequence.truth.push_back (truthBetween (first, first_hits, view, threads_));
    if (options_.successive_truth && k + 1 < options_.frames)
      sequence.successive_truth.push_back (
          truthBetween (view, hits, viewAt (k + 1), threads_));
    addPoses (k, sequence);
  }
  return sequence;
}

} // namespace

SyntheticSequence
synthesize (const SequenceOptions& options)
{
  std::string why;
  if (!options.isValid (&why))
    throw InvalidInput ("cannot synthesize a sequence: " + why);
  return SequenceRenderer (options).draw();
}

} // namespace pcl_msf::synthetic
