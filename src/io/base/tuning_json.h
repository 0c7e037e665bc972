// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "io/base/json.h"
#include <pcl_msf/export.h>

namespace pcl_msf::io {

/** \brief Adds which tuned values are in use: "tuning_hash", and those that are not the
 * defaults as "tuning". */
PCL_MSF_EXPORT void
addTuning (Json& json);

} // namespace pcl_msf::io
