// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace pcl_msf::io {

/** \brief A JSON value whose keys keep their order. Numbers need no locale, read back
 * exactly and become null when they are not finite. */
using Json = nlohmann::ordered_json;

/** \brief As text, two blanks of indent a level; bytes that are no UTF-8 are replaced.
 */
inline std::string
jsonText (const Json& json)
{
  return json.dump (2, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace pcl_msf::io
