// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/io/datasets.h>

#include <memory>
#include <string>
#include <vector>

namespace pcl_msf::io {

using Sequences = std::vector<std::shared_ptr<const RgbdSequence>>;

// Each opens the sequences of one kind below a path: none when nothing of the kind is
// there, IoError when it is there and damaged.

/** \brief The project's own layout (DataFolder). */
Sequences
openCases (const std::string& path, const DatasetOptions& options);

/** \brief TUM RGB-D: rgb.txt, depth.txt, groundtruth.txt. */
Sequences
openTum (const std::string& path, const DatasetOptions& options);

/** \brief MPI-Sintel with its depth and camera files. */
Sequences
openSintel (const std::string& path, const DatasetOptions& options);

/** \brief Virtual KITTI 1.3.1. */
Sequences
openVirtualKitti1 (const std::string& path, const DatasetOptions& options);

/** \brief Virtual KITTI 2. */
Sequences
openVirtualKitti2 (const std::string& path, const DatasetOptions& options);

/** \brief FlyingThings3D, Monkaa and Driving. */
Sequences
openFlyingThings (const std::string& path, const DatasetOptions& options);

/** \brief KITTI 2015 scene flow, with dense disparities of the user's. */
Sequences
openKitti2015 (const std::string& path, const DatasetOptions& options);

/** \brief Middlebury stereo pairs as a camera that moves sideways. */
Sequences
openMiddlebury (const std::string& path, const DatasetOptions& options);

/** \brief Any folder of colour and depth images. */
Sequences
openFolder (const std::string& path, const DatasetOptions& options);

/** \brief Folders of organized .pcd files. */
Sequences
openClouds (const std::string& path, const DatasetOptions& options);

} // namespace pcl_msf::io
