// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <pcl_msf/errors.h>

#include <string>

namespace pcl_msf::testing {

/** \brief The call throws an IoError that names the file and the field. */
template <typename Call>
void
expectIoError (const Call& call, const std::string& file, const std::string& field)
{
  try {
    call();
    ADD_FAILURE() << "no IoError for " << file << ", " << field;
  }
  catch (const IoError& e) {
    EXPECT_THAT (e.what(), ::testing::HasSubstr (file));
    EXPECT_THAT (e.what(), ::testing::HasSubstr (field));
    EXPECT_THAT (e.what(), ::testing::Not (::testing::HasSubstr ("\n")));
  }
}

} // namespace pcl_msf::testing
