// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/synthetic/synthetic_sequence.h>

#include <cstring>
#include <map>

namespace pcl_msf::test {

constexpr int width = 192, height = 144; // of the sequences below

inline SequenceOptions
smallOptions (Scene scene, MotionSize motion = MotionSize::Easy)
{
  SequenceOptions options;
  options.scene = scene;
  options.motion = motion;
  options.width = width;
  options.height = height;
  options.seed = 3;
  return options;
}

/** Two frames of a scene, rendered once for all tests. */
inline const SyntheticSequence&
easySequence (Scene scene)
{
  static std::map<Scene, SyntheticSequence> sequences;
  SyntheticSequence& sequence = sequences[scene];
  if (sequence.frames.empty()) {
    SequenceOptions options = smallOptions (scene);
    sequence = synthesize (options);
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
