// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/multi_frame_level.h"

#include "core/body_noise.h"
#include "core/exposure.h"
#include "core/parallel_for.h"

namespace pcl_msf {

namespace {

constexpr int kProbesPerSegment = 64;

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
  parallelFor (scene.threads, count, 1, [&] (int f) {
    FrameLevel frame = scene.frames[f].levels()[level];
    if (!frame.intensity.empty())
      frame.intensity = correctIntensity (frame, scene.exposure[f], scene.falloff);
    if (f == scene.pairs.reference() && level == 0 && !scene.fused_depth.empty())
      frame.inverse_depth = scene.fused_depth;
    PointOptions options{scene.noise, relative_tolerance, {}, 0, 1};
    if (!labels[f].empty())
      pixels_[f] = groupPixels (frame, labels[f], scene.segments, options);
    options.max_per_segment = kProbesPerSegment;
    if (f == scene.pairs.reference())
      probes_ = groupPixels (frame, labels[f], scene.segments, options);
    else
      textures_[f] = std::make_unique<Texture> (frame);
  });
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
MultiFrameLevel::sharpenRigidBodies (const MultiFrameState& state)
{
  for (std::size_t f = 0; f < pixels_.size(); ++f) {
    std::vector<PairTerms> from;
    for (const int p : scene_.used)
      if (scene_.pairs[p].from == static_cast<int> (f))
        from.push_back ({p, data_[p].get(), nullptr, 1.0});
    if (!from.empty())
      pcl_msf::sharpenRigidBodies (from, state, scene_.threads, pixels_[f]);
  }
}

void
MultiFrameLevel::sweep (const MultiFrameState& state, DataTerm::Pass pass)
{
  for (const int p : scene_.used)
    data_[p]->sweep (state.ofPair (p), pass);
}

} // namespace pcl_msf
