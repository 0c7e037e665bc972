// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/data/window_level.h"

#include "core/base/parallel_for.h"
#include "core/data/body_noise.h"
#include "core/frame/light_change.h"
#include "core/window/exposure.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

/** Of a level with few pixels all are taken. */
int
thinningOf (const WindowScene& scene, int level)
{
  const DataTuning& tuning = scene.tuning.data;
  const std::size_t pixels =
      scene.frames[scene.pairs.reference()].levels()[level].inverse_depth.total();
  if (level > 1 || pixels < static_cast<std::size_t> (tuning.least_thinned))
    return 1;
  return level == 0 ? tuning.finest_thinning : tuning.half_thinning;
}

} // namespace

double
meanShare (const WindowScene& scene, int level)
{
  if (scene.change.local)
    return 0.0;
  const int side = (2 * scene.tuning.frame.brightness.contrast_radius + 1) << level;
  const double tile = scene.tuning.data.correlation.tile; // that the area was found in
  const double inside = std::min (1.0, side * side / (tile * tile));
  return 1.0 / std::sqrt (1.0 + (scene.brightness_area - 1.0) * inside);
}

PointOptions
pointOptions (const WindowScene& scene, int level)
{
  const DataTuning& tuning = scene.tuning.data;
  return {scene.noise,
          tuning.relative_tolerance * (1 << level),
          scene.change,
          0,
          scene.threads,
          level,
          thinningOf (scene, level),
          scene.tuning.segments.pixels};
}

SegmentPixels
probePoints (const FrameLevel& level,
             const cv::Mat& labels,
             const WindowScene& scene,
             PointOptions options)
{
  options.max_per_segment = scene.tuning.data.probes;
  return groupPixels (level, labels, scene.segments, options);
}

cv::Mat
comparableIntensity (const WindowScene& scene, int f, int level)
{
  const FrameLevel& frame = scene.frames[f].levels()[level];
  const bool correct = !frame.intensity.empty() && !scene.exposure.empty();
  const cv::Mat intensity =
      correct ? correctIntensity (frame, scene.exposure[f], scene.falloff)
              : frame.intensity;
  const double mean_share = meanShare (scene, level);
  if (mean_share >= 1.0)
    return intensity;
  return localContrast (
      intensity, scene.tuning.frame.brightness.contrast_radius, mean_share);
}

namespace {

void
prepareFrame (const WindowScene& scene,
              int f,
              int level,
              const cv::Mat& labels,
              const PointOptions& options,
              const LevelNeeds& needs,
              LevelPoints& out)
{
  FrameLevel frame = scene.frames[f].levels()[level];
  frame.intensity = comparableIntensity (scene, f, level);
  if (needs.means && !scene.change.local)
    out.means[f] =
        localMeans (frame.intensity, scene.tuning.frame.brightness.contrast_radius);
  const bool reference = f == scene.pairs.reference();
  if (reference && level == 0 && !scene.fused_depth.empty())
    frame.inverse_depth = scene.fused_depth;
  if (!labels.empty())
    out.pixels[f] = groupPixels (frame, labels, scene.segments, options);
  if (reference && needs.results && options.thinning > 1) {
    PointOptions all = options;
    all.thinning = 1;
    out.whole = std::make_unique<SegmentPixels> (
        groupPixels (frame, labels, scene.segments, all));
  }
  if (reference)
    out.probes = probePoints (frame, labels, scene, options);
  else
    out.textures[f] = std::make_unique<Texture> (frame);
}

} // namespace

LevelPoints
prepareLevel (const WindowScene& scene,
              int level,
              const std::vector<cv::Mat>& labels,
              const PointOptions& options,
              const LevelNeeds& needs)
{
  const int count = static_cast<int> (scene.frames.size());
  const bool many = count > 2; // else threads share a frame's points
  PointOptions of_frame = options;
  if (many)
    of_frame.threads = 1;
  LevelPoints points;
  points.pixels.resize (count);
  points.textures.resize (count);
  points.means.resize (count);
  parallelFor (many ? options.threads : 1, count, 1, [&] (int f) {
    prepareFrame (scene, f, level, labels[f], of_frame, needs, points);
  });
  return points;
}

void
leaveMeansOut (const WindowScene& scene, int level, LevelPoints& points)
{
  const int reference = scene.pairs.reference();
  const cv::Mat& means = points.means[reference];
  const auto share = static_cast<float> (1.0 - meanShare (scene, level));
  if (means.empty() || share <= 0.0f)
    return;
  for (SegmentPixels* pixels : {&points.pixels[reference], &points.probes})
    for (std::size_t i = 0; i < pixels->pixel.size(); ++i) {
      const int v = pixels->pixel[i] / means.cols;
      const float mean = means.ptr<float> (v)[pixels->pixel[i] - v * means.cols];
      pixels->intensity[i] -= share * (scene.change.gain * mean + scene.change.offset);
    }
  points.textures[1 - reference]->subtract (
      points.means[1 - reference], share, scene.threads);
}

WindowLevel::WindowLevel (const WindowScene& scene,
                          int level,
                          LevelPoints points,
                          const EnergyParameters& energy)
: scene_ (scene)
, energy_ (energy)
, points_ (std::move (points))
, data_ (scene.pairs.count())
, probe_data_ (scene.pairs.count())
, focal_length_ (scene.frames[scene.pairs.reference()].levels()[level].camera.fx)
{
  setAreas();
  for (const int p : scene.used) {
    const FramePairs::Pair& pair = scene.pairs[p];
    const auto term = [&] (const SegmentPixels& pixels) {
      auto made = std::make_unique<DataTerm> (
          pixels,
          *points_.textures[pair.to],
          makeRules (energy, pixels, scene.tuning.data.missing),
          scene.threads);
      // The finest level goes without: there the energy is the method's alone.
      if (scene.flow)
        made->setFlow (*scene.flow,
                       1.0 / residualScale (energy, pixels),
                       level > 0 ? scene.tuning.start.evidence.solving : 0.0);
      return made;
    };
    data_[p] = term (points_.pixels[pair.from]);
    if (pair.from == scene.pairs.reference())
      probe_data_[p] = term (points_.probes);
  }
}

/** What residuals are worth may have been measured since the points were made. */
void
WindowLevel::setAreas()
{
  for (SegmentPixels& pixels : points_.pixels)
    pixels.areas = scene_.noise.areas;
  points_.probes.areas = scene_.noise.areas;
}

std::vector<PairTerms>
WindowLevel::terms() const
{
  std::vector<PairTerms> terms;
  for (const int p : scene_.used)
    terms.push_back ({p,
                      data_[p].get(),
                      probe_data_[p].get(),
                      residualScale (energy_, data_[p]->pixels())});
  return terms;
}

void
WindowLevel::rescaleBodyNoise (const WindowState& state)
{
  for (std::size_t f = 0; f < points_.pixels.size(); ++f) {
    std::vector<PairTerms> from;
    for (const PairTerms& pair : terms())
      if (scene_.pairs[pair.pair].from == static_cast<int> (f))
        from.push_back (pair);
    if (from.empty())
      continue;
    pcl_msf::rescaleBodyNoise (
        from, state, scene_.tuning.data.body_noise, scene_.threads, points_.pixels[f]);
    for (const PairTerms& pair : from)
      data_[pair.pair]->forget();
  }
}

void
WindowLevel::reweigh()
{
  setAreas();
  for (const auto& terms : {&data_, &probe_data_})
    for (const std::unique_ptr<DataTerm>& term : *terms)
      if (term)
        term->setRules (
            makeRules (energy_, term->pixels(), scene_.tuning.data.missing));
}

void
WindowLevel::sweep (const WindowState& state, DataTerm::Pass pass)
{
  for (const int p : scene_.used)
    data_[p]->sweep (state.ofPair (p), pass);
}

void
WindowLevel::rememberSums()
{
  for (const int p : scene_.used)
    data_[p]->rememberSums();
}

void
WindowLevel::recallSums (const std::vector<int>& segments)
{
  for (const int p : scene_.used)
    for (const int k : segments)
      data_[p]->recallSums (k);
}

void
WindowLevel::completeSums()
{
  for (const int p : scene_.used)
    data_[p]->completeSums();
}

} // namespace pcl_msf
