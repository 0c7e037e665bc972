// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/data/window_level.h"

#include "core/base/parallel_for.h"
#include "core/data/body_noise.h"
#include "core/window/exposure.h"

namespace pcl_msf {

PointOptions
pointOptions (const WindowScene& scene, int level)
{
  return {scene.noise,
          scene.tuning.data.relative_tolerance * (1 << level),
          scene.change,
          0,
          scene.threads,
          level,
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

WindowLevel::WindowLevel (const WindowScene& scene,
                          int level,
                          const std::vector<cv::Mat>& labels,
                          const EnergyParameters& energy)
: scene_ (scene)
, energy_ (energy)
, pixels_ (scene.frames.size())
, textures_ (scene.frames.size())
, data_ (scene.pairs.count())
, probe_data_ (scene.pairs.count())
, focal_length_ (scene.frames[scene.pairs.reference()].levels()[level].camera.fx)
{
  const int count = static_cast<int> (scene.frames.size());
  const bool many = count > 2; // else threads share a frame's points
  parallelFor (many ? scene.threads : 1, count, 1, [&] (int f) {
    prepareFrame (f, level, labels[f], many ? 1 : scene.threads);
  });
  for (const int p : scene.used) {
    const FramePairs::Pair& pair = scene.pairs[p];
    const auto term = [&] (const SegmentPixels& points) {
      auto made = std::make_unique<DataTerm> (
          points,
          *textures_[pair.to],
          makeRules (energy, points, scene.tuning.data.missing),
          scene.threads);
      // The finest level knows better: there the energy is the method's alone.
      if (scene.flow)
        made->setFlow (*scene.flow,
                       1.0 / residualScale (energy, points),
                       level > 0 ? scene.tuning.start.evidence.solving : 0.0);
      return made;
    };
    data_[p] = term (pixels_[pair.from]);
    if (pair.from == scene.pairs.reference())
      probe_data_[p] = term (probes_);
  }
}

void
WindowLevel::prepareFrame (int f, int level, const cv::Mat& labels, int threads)
{
  FrameLevel frame = scene_.frames[f].levels()[level];
  if (!frame.intensity.empty() && !scene_.exposure.empty())
    frame.intensity = correctIntensity (frame, scene_.exposure[f], scene_.falloff);
  const bool reference = f == scene_.pairs.reference();
  if (reference && level == 0 && !scene_.fused_depth.empty())
    frame.inverse_depth = scene_.fused_depth;
  PointOptions options = pointOptions (scene_, level);
  options.threads = threads;
  if (!labels.empty())
    pixels_[f] = groupPixels (frame, labels, scene_.segments, options);
  if (reference)
    probes_ = probePoints (frame, labels, scene_, options);
  else
    textures_[f] = std::make_unique<Texture> (frame);
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
  for (std::size_t f = 0; f < pixels_.size(); ++f) {
    std::vector<PairTerms> from;
    for (const PairTerms& pair : terms())
      if (scene_.pairs[pair.pair].from == static_cast<int> (f))
        from.push_back (pair);
    if (from.empty())
      continue;
    pcl_msf::rescaleBodyNoise (
        from, state, scene_.tuning.data.body_noise, scene_.threads, pixels_[f]);
    for (const PairTerms& pair : from)
      data_[pair.pair]->forget();
  }
}

void
WindowLevel::reweigh()
{
  for (SegmentPixels& points : pixels_)
    points.areas = scene_.noise.areas;
  probes_.areas = scene_.noise.areas;
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
