// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/base/lazy_library.h"
#include <gmock/gmock.h>
#include <pcl_msf/errors.h>

namespace {

using namespace pcl_msf;
using ::testing::HasSubstr;

TEST (LazyLibrary, GivesTheFunctionOfTheFirstFileThatHasIt)
{
  auto* const cosine =
      loadFunction<double (double)> ({"libnot_there.so.1", "libm.so.6"}, "cos");
  EXPECT_DOUBLE_EQ (cosine (0.0), 1.0);
  EXPECT_EQ (loadFunction<double (double)> ({"libm.so.6"}, "cos"), cosine);
}

TEST (LazyLibrary, NamesWhatIsMissing)
{
  const auto problem = [] (const char* file, const char* symbol) {
    try {
      loadSymbol ({file}, symbol);
    }
    catch (const InvalidInput& error) {
      return std::string (error.what());
    }
    return std::string ("none");
  };
  EXPECT_THAT (problem ("libnot_there.so.1", "cos"), HasSubstr ("libnot_there.so.1"));
  EXPECT_THAT (problem ("libm.so.6", "no_such_function"),
               HasSubstr ("no_such_function"));
  EXPECT_THAT (problem ("libm.so.6", "no_such_function"), HasSubstr ("install"));
}

} // namespace
