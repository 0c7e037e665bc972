// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/io/datasets.h>
#include <pcl_msf/synthetic/synthetic_sequence.h>

namespace pcl_msf::testing {

/** \brief Three frames of moving bodies, 96x72, without noise. */
inline const synthetic::SyntheticSequence&
smallSequence ()
{
  static const synthetic::SyntheticSequence sequence = [] {
    synthetic::SequenceOptions options;
    options.scene = synthetic::SceneKind::MultiBody;
    options.width = 96;
    options.height = 72;
    options.frames = 3;
    options.successive_truth = true;
    return synthetic::synthesize (options);
  }();
  return sequence;
}

/** \brief For data sets whose published camera is not that of the small sequence. */
inline io::DatasetOptions
withCamera ()
{
  io::DatasetOptions options;
  options.camera = smallSequence().camera;
  return options;
}

} // namespace pcl_msf::testing
