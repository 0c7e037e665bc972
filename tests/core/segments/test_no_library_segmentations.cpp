// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/analytic_scene.h"
#include <gmock/gmock.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/oversegmentation.h>

namespace {

using namespace pcl_msf;

/** What a library built without ximgproc answers to a method that needs it. */
class NoLibrarySegmentations : public testing::TestWithParam<SegmentationMethod> {};

TEST_P (NoLibrarySegmentations, SaysWhatIsMissing)
{
  const test::AnalyticScene scene = test::roomWithBox();
  SegmentationParameters parameters;
  parameters.method = GetParam();
  try {
    Oversegmentation::fromFrame (scene.frame (scene.render (false)), parameters);
    FAIL() << "no complaint";
  }
  catch (const InvalidInput& error) {
    EXPECT_THAT (error.what(), testing::HasSubstr ("ximgproc"));
    EXPECT_THAT (error.what(), testing::HasSubstr ("TangentPlane"));
  }
}

INSTANTIATE_TEST_SUITE_P (Methods,
                          NoLibrarySegmentations,
                          testing::Values (SegmentationMethod::Felzenszwalb,
                                           SegmentationMethod::Slic));

TEST (WithoutXimgproc, LeavesTheOtherMethods)
{
  const test::AnalyticScene scene = test::roomWithBox();
  EXPECT_GT (Oversegmentation::fromFrame (scene.frame (scene.render (false))).size(),
             1);
}

} // namespace
