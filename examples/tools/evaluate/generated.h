// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/io/rgbd_sequence.h>
#include <pcl_msf/synthetic/sequence_options.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief Which generated sequences to evaluate. */
struct GeneratedOptions {
  std::vector<synthetic::SceneKind> scenes{synthetic::allScenes()};
  std::vector<synthetic::MotionSize> motions{synthetic::MotionSize::Easy,
                                             synthetic::MotionSize::Large};
  std::vector<synthetic::Sensor> sensors{synthetic::Sensor::Ideal,
                                         synthetic::Sensor::Kinect};
  synthetic::CameraEffects effects;
  bool motion_blur{false};
  std::optional<LensDistortion> distortion; ///< that frames are freed from
  int width{640};
  int height{480};
  int frames{2};
  unsigned seed{1};
  int noise_seeds{1}; ///< every sequence with so much different noise
  unsigned threads{0};
};

/** \brief All combinations, named "SCENE_MOTION_SENSOR". A sequence is rendered when it
 * is first asked for; only the last one is kept. */
std::vector<std::shared_ptr<const io::RgbdSequence>>
openGenerated (const GeneratedOptions& options);

} // namespace pcl_msf::tool
