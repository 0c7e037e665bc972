// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/io/datasets.h>

#include <memory>
#include <string>
#include <vector>

namespace pcl_msf::io {

using Sequences = std::vector<std::shared_ptr<const RgbdSequence>>;

/** \brief The project's own layout (DataFolder). Like all of these: the sequences below
 * a path, none when nothing of the kind is there; IoError when it is and is damaged. */
Sequences
openCases (const std::string& path, const DatasetOptions& options);

} // namespace pcl_msf::io
