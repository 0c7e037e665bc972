// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/synthetic/synthetic_sequence.h>

#include <cstring>
#include <map>

namespace pcl_msf::test {

constexpr int width = 192, height = 144; // of the sequences below

inline synthetic::SequenceOptions
smallOptions (synthetic::SceneKind scene,
              synthetic::MotionSize motion = synthetic::MotionSize::Easy)
{
  synthetic::SequenceOptions options;
  options.scene = scene;
  options.motion = motion;
  options.width = width;
  options.height = height;
  options.seed = 3;
  return options;
}

/** Two frames of a scene, rendered once for all tests. */
inline const synthetic::SyntheticSequence&
easySequence (synthetic::SceneKind scene)
{
  static std::map<synthetic::SceneKind, synthetic::SyntheticSequence> sequences;
  synthetic::SyntheticSequence& sequence = sequences[scene];
  if (sequence.frames.empty()) {
    synthetic::SequenceOptions options = smallOptions (scene);
    sequence = synthetic::synthesize (options);
  }
  return sequence;
}

inline double
gray (const cv::Vec3b& bgr)
{
  return (bgr[0] + bgr[1] + bgr[2]) / 3.0;
}

inline bool
sameBits (const cv::Mat& a, const cv::Mat& b)
{
  return a.size() == b.size() && a.type() == b.type() &&
         std::memcmp (a.data, b.data, a.total() * a.elemSize()) == 0;
}

} // namespace pcl_msf::test
