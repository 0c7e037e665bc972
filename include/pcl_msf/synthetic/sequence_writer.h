// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>
#include <pcl_msf/synthetic/synthetic_sequence.h>

#include <string>

namespace pcl_msf::synthetic {

/** \brief How a sequence lies on disk. K counts from 0, K4 from 0001.
 *
 * Cases: `color_K.png`, `depth_K.dpt` or `depth_K.png`, `camera.txt` (fx fy cx cy width
 * height depth_scale), `gt/flow_0_K.flo` (1e10 = unknown), `gt/scene_flow_0_K.pfm` (x y
 * z in file order, NaN = unknown), `gt/visible_0_K.png` (255 = seen in both),
 * `gt/labels_0.png` (8 bit, 255 = none), `gt/pose_K.txt` (4x4, static scene, frame-K
 * point from frame-0 point), `gt/object_poses_K.txt` (a line per body: label, rigid 1
 * or 0, the upper 3x4 of frame K from frame 0 by rows, name). Truth starts with K = 1.
 *
 * Tum: `rgb/T.png`, `depth/T.png` (16 bit, 5000), `rgb.txt`, `depth.txt`,
 * `groundtruth.txt` (T tx ty tz qx qy qz qw, frame-0 from camera), 30 Hz.
 *
 * Sintel: `clean/NAME/frame_K4.png`, `depth/NAME/frame_K4.dpt`,
 * `camdata_left/NAME/frame_K4.cam`, `flow/NAME/frame_K4.flo` and
 * `occlusions/NAME/frame_K4.png` (255 = hidden in the next frame) and
 * `invalid/NAME/frame_K4.png` (255 = leaves the image, or no truth), to the next frame
 * for sequences with `successive_truth`, otherwise for the first frame only. */
enum class SequenceLayout { Cases, Tum, Sintel };

/** \brief How Cases stores depth. */
enum class DepthFormat {
  Automatic, ///< Float for a sequence without sensor model, else Png16
  Float,     ///< `.dpt`, float metres, 0 = none: exact
  Png16      ///< 16-bit PNG, value / depth_scale metres, 0 = none
};

struct SequenceWriterOptions {
  SequenceLayout layout{SequenceLayout::Cases};
  DepthFormat depth_format{DepthFormat::Automatic};
  double depth_scale{5000.0}; ///< of 16-bit depth, 1 / metres, > 0; not for Tum

  /** \brief Sintel's NAME; empty = the scene's name. */
  std::string name;
};

/** \brief Writes a sequence below a folder that is made when it does not exist; files
 * of the same names are replaced. Depth beyond 65535 / depth_scale becomes "none" in 16
 * bit. \throws IoError naming the file that cannot be written \throws InvalidInput for
 * a sequence without frames, a depth_scale that is not > 0, or one with which 16 bit
 * hold none of its depth or most of that is less than one unit; nothing is written */
PCL_MSF_EXPORT void
writeSequence (const SyntheticSequence& sequence,
               const std::string& folder,
               const SequenceWriterOptions& options = {});

} // namespace pcl_msf::synthetic
