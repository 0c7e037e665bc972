// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <gtest/gtest.h>

#include "support/run_tool.h"
#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace pcl_msf::testing {

/** \brief The tool ended with 1 and one line on stderr that has all the words. */
inline void
expectRefusal (const ToolRun& run,
               const std::string& arguments,
               const std::vector<std::string>& words = {})
{
  EXPECT_EQ (run.status, 1) << arguments;
  EXPECT_EQ (run.errorLines(), 1) << arguments << "\n" << run.err;
  for (const std::string& word : words)
    EXPECT_THAT (run.err, ::testing::HasSubstr (word)) << arguments;
}

} // namespace pcl_msf::testing
