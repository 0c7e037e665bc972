// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/tuning_json.h"

#include "core/base/tuning/tuning.h"

namespace pcl_msf::io {

void
addTuning (Json& json)
{
  json["tuning_hash"] = tuningHash (currentTuning());
  for (const auto& [name, text] : changedTuning())
    json["tuning"][name] = text;
}

} // namespace pcl_msf::io
