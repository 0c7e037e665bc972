// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <gtest/gtest.h>

#include "evaluate/score.h"
#include <gmock/gmock.h>

#include <string>

namespace pcl_msf::testing {

/** \brief A row of a pair from frame 0 to 1 with an error and a time of 0.5 s. */
inline tool::Row
makeRow (std::size_t pair, const std::string& method, double epe)
{
  tool::Row row;
  row.pair = pair;
  row.dataset = "generated";
  row.sequence = "scene_" + std::to_string (pair);
  row.to = 1;
  row.method = method;
  row.score.epe_visible = epe;
  row.score.sec = 0.5;
  return row;
}

/** \brief What the error of a call says; a failure when there is none. */
template <typename Error, typename Call>
std::string
messageOf (const Call& call)
{
  try {
    call();
  }
  catch (const Error& e) {
    return e.what();
  }
  ADD_FAILURE() << "nothing thrown";
  return {};
}

} // namespace pcl_msf::testing
