// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/multi_frame_level.h"

namespace pcl_msf {

namespace {

constexpr int kProbesPerSegment = 64;

/** What takes a frame's intensity back to the reference's. */
BrightnessChange
inverse (const BrightnessChange& change)
{
  return {1.0f / change.gain, -change.offset / change.gain};
}

std::unique_ptr<Texture>
makeTexture (const FrameLevel& level, const BrightnessChange& exposure)
{
  FrameLevel same = level;
  const BrightnessChange back = inverse (exposure);
  if (!level.intensity.empty())
    level.intensity.convertTo (same.intensity, CV_32F, back.gain, back.offset);
  return std::make_unique<Texture> (same);
}

} // namespace

MultiFrameLevel::MultiFrameLevel (const MultiFrameScene& scene,
                                  int level,
                                  const std::vector<cv::Mat>& labels,
                                  const EnergyParameters& energy,
                                  double relative_tolerance)
: scene_ (scene)
, pixels_ (scene.frames.size())
, textures_ (scene.frames.size())
, data_ (scene.pairs.count())
, probe_data_ (scene.pairs.count())
, focal_length_ (scene.frames[scene.pairs.reference()].levels()[level].camera.fx)
{
  const int count = static_cast<int> (scene.frames.size());
#pragma omp parallel for schedule(dynamic, 1) num_threads(scene.threads)
  for (int f = 0; f < count; ++f) {
    const FrameLevel& frame = scene.frames[f].levels()[level];
    PointOptions options{
        scene.noise, relative_tolerance, inverse (scene.exposure[f]), 0, 1};
    if (!labels[f].empty())
      pixels_[f] = groupPixels (frame, labels[f], scene.segments, options);
    options.max_per_segment = kProbesPerSegment;
    if (f == scene.pairs.reference())
      probes_ = groupPixels (frame, labels[f], scene.segments, options);
    else
      textures_[f] = makeTexture (frame, scene.exposure[f]);
  }
  for (const int p : scene.used) {
    const FramePairs::Pair& pair = scene.pairs[p];
    data_[p] = std::make_unique<DataTerm> (pixels_[pair.from],
                                           *textures_[pair.to],
                                           makeRules (energy, pixels_[pair.from]),
                                           scene.threads);
    if (pair.from == scene.pairs.reference())
      probe_data_[p] = std::make_unique<DataTerm> (
          probes_, *textures_[pair.to], makeRules (energy, probes_), scene.threads);
  }
}

void
MultiFrameLevel::sweep (const MultiFrameState& state, DataTerm::Pass pass)
{
  for (const int p : scene_.used)
    data_[p]->sweep (state.ofPair (p), pass);
}

} // namespace pcl_msf
