// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/io/rgbd_sequence.h>
#include <pcl_msf/pinhole_camera.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl_msf::io {

/** \brief What a data set does not say of itself, or what is to be taken instead. */
struct DatasetOptions {
  /** \brief Camera of all frames, pixels; none (default) = the data set's own. */
  std::optional<PinholeCamera> camera;

  /** \brief Integer units of depth per metre, > 0; none (default) = the data set's own.
   * Without effect where depth is stored as float metres or as a disparity. */
  std::optional<double> depth_scale;

  /** \brief Rendering: "clean" or "final"; Sintel and FlyingThings3D only. */
  std::string pass{"clean"};

  /** \brief Which camera of a stereo rig: "left" or "right"; FlyingThings3D and
   * Virtual KITTI 2 only, the others have no depth of the right one. */
  std::string view{"left"};

  /** \brief Between colour and depth, and between colour and pose; TUM only. Seconds,
   * > 0. */
  double max_time_difference{0.02};
};

/** \brief The kinds of data sets that `openDataset` takes besides "auto". */
const std::vector<std::string>&
datasetKinds ();

/** \brief Opens all sequences below a path, sorted by name (numbers by value).
 *
 * \param kind one of `datasetKinds`, or "auto": the only kind whose marks are there
 * \param path a data set's top folder, a part of it, or a single sequence
 * \return one sequence or more; nothing but lists and cameras has been read
 * \throws IoError when nothing of that kind is there, or its lists are damaged
 * \throws InvalidInput for an unknown kind and for options outside their ranges */
std::vector<std::shared_ptr<const RgbdSequence>>
openDataset (const std::string& kind,
             const std::string& path,
             const DatasetOptions& options = {});

} // namespace pcl_msf::io
