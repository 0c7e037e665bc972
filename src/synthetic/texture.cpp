// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <synthetic/texture.h>

#include <algorithm>
#include <cmath>

namespace pcl_msf::synthetic {
namespace {

/** An arbitrary rotation: lattice planes shall not show on axis-parallel surfaces. */
Eigen::Vector3f
turned (const Eigen::Vector3f& p)
{
  return {0.6427876f * p.x() + 0.3830222f * p.y() + 0.6634139f * p.z(),
          -0.7544065f * p.x() + 0.4698463f * p.y() + 0.4596988f * p.z() + 0.37f,
          -0.1356274f * p.x() - 0.7959648f * p.y() + 0.5899569f * p.z() + 0.11f};
}

float
smoothStep (float low, float high, float x)
{
  const float t = std::min (1.0f, std::max (0.0f, (x - low) / (high - low)));
  return t * t * (3.0f - 2.0f * t);
}

/** Octaves from the coarsest cell to the pixel; those near its size fade out. */
float
octaves (const Texture& texture,
         const LatticeNoise& noise,
         const Eigen::Vector3f& place,
         float footprint)
{
  const float smallest = std::max (footprint, texture.finest);
  float cell = texture.coarsest;
  float amplitude = 1.0f, sum = 0.0f;
  Eigen::Vector3f p = turned (place);
  while (cell > smallest) {
    const float fade = std::min (1.0f, cell / smallest - 1.0f);
    sum += fade * amplitude * noise (p / cell);
    amplitude *= 0.93f;
    cell *= 0.5f;
    p = turned (p);
  }
  return sum;
}

/** 1 on a joint between tiles, 0 elsewhere, along one axis. */
float
joint (float x, float size, float footprint)
{
  const float half_width = 0.02f * size + 0.5f * footprint;
  const float strength = 0.02f * size / half_width;
  const float distance = std::abs (x / size - std::round (x / size)) * size;
  return strength * (1.0f - smoothStep (half_width, half_width + footprint, distance));
}

/** Share of the second colour. */
float
patternShare (const Texture& texture,
              const LatticeNoise& noise,
              const Eigen::Vector3f& p,
              const Eigen::Vector3f& normal,
              float footprint)
{
  const float size = texture.pattern_size;
  switch (texture.pattern) {
  case Pattern::Patches: {
    const float edge = std::max (0.04f, 1.5f * footprint / size);
    return smoothStep (-edge, edge, noise (turned (p / size)));
  }
  case Pattern::Tiles: {
    float share = 0.0f;
    for (int a = 0; a < 3; ++a)
      if (std::abs (normal[a]) < 0.7f)
        share = std::max (share, joint (p[a], size, footprint));
    return share;
  }
  case Pattern::Stripes: {
    const float phase = std::abs (p.y() / size - std::round (p.y() / size));
    const float edge = std::max (0.02f, footprint / size);
    return edge > 0.5f ? 0.5f : smoothStep (0.25f - edge, 0.25f + edge, phase);
  }
  default:
    return 0.0f;
  }
}

} // namespace

Eigen::Vector3f
textureColor (const Texture& texture,
              const LatticeNoise& noise,
              const Eigen::Vector3f& place,
              const Eigen::Vector3f& normal,
              float footprint)
{
  const Eigen::Vector3f p = place + texture.offset;
  const float share = patternShare (texture, noise, place, normal, footprint);
  const Eigen::Vector3f tone = texture.color + share * (texture.second - texture.color);
  const float value = octaves (texture, noise, p, footprint);
  const float tint = noise (turned (p) / (0.37f * texture.coarsest));
  const float gain = 1.0f + texture.contrast * value;
  const Eigen::Vector3f warm (-0.25f, 0.0f, 0.25f);
  return (tone.array() * (gain + texture.contrast * tint * warm.array())).matrix();
}

} // namespace pcl_msf::synthetic
