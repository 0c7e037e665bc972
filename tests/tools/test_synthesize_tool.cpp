// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "tools/tool_chain.h"
#include <pcl_msf/io/datasets.h>
#include <pcl_msf/synthetic/synthetic_sequence.h>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using ::testing::HasSubstr;
using ::testing::Not;

namespace fs = std::filesystem;

using SynthesizeTool = ToolChain;

TEST_F (SynthesizeTool, NamesWhatWasWritten)
{
  const std::string to = folder_ ("x") + " ";
  const std::vector<std::pair<std::string, std::string>> refused{
      {"--samples 0", "--samples = 0 must lie between 1 and 8"},
      {"--motion-pixels 900", "--motion-pixels = 900 must"},
      {"-motion_pixels 900", "--motion-pixels = 900 must"},
      {"--depth-shift 0,30", "--depth-shift = 30 must"},
      {"--exposure-change 2", "--exposure-change = 2 must"},
      {"--lens -5,0,0,0", "--lens: no lens distortion for 640x480"},
      {"--depth-scale 0", "--depth-scale: 0, must be > 0"},
      {"--body hand --points 5", "--points: must be in"}};
  for (const auto& [options, words] : refused)
    expectRefusal ("synthesize", to + options, {"pcl_msf_synthesize: " + words});
  EXPECT_FALSE (fs::exists (folder_ ("x")));
}

TEST_F (SynthesizeTool, NamesTheFolderThatHoldsOtherFiles)
{
  fs::create_directory (folder_ ("real"));
  writeFile (folder_ ("real/color_7.jpg"), "a recording");
  expectRefusal ("synthesize",
                 folder_ ("real") + " --width 160 --height 120",
                 {"pcl_msf_synthesize: FOLDER: ", "real/color_7.jpg is in the way"});
}

TEST_F (SynthesizeTool, RefusesADepthScaleThatHoldsNoDepth)
{
  const std::string small =
      folder_ ("seq") + " --width 64 --height 48 --frames 1 --depth ";
  for (const char* scale : {"50000", "0.1", "0.2"})
    expectRefusal ("synthesize",
                   small + "png --depth-scale " + scale,
                   {std::string ("--depth-scale = ") + scale + " holds ",
                    " m in 16 bit, the scene's depth is ",
                    "for example 5000"});
  EXPECT_FALSE (fs::exists (folder_ ("seq/depth_0.png")));
  expectSuccess ("synthesize", small + "dpt --depth-scale 50000");
  expectSuccess ("synthesize", small + "png --depth-scale 1000");
}

/** The layout holds no camera: what is read is right all the same, or told. */
TEST_F (SynthesizeTool, TumIsRenderedWithTheReadersCamera)
{
  const ToolRun made = run ("synthesize", folder_ ("tum") + " --layout tum --frames 2");
  ASSERT_EQ (made.status, 0) << made.err;
  EXPECT_THAT (made.out, Not (HasSubstr ("--camera")));
  const auto all = io::openDataset (io::DatasetKind::Automatic, folder_ ("tum"), {});
  ASSERT_EQ (all.size(), 1U);
  const io::RgbdImages read = all.front()->frame (0);
  synthetic::SequenceOptions options; // the tool's, too
  options.frames = 2;
  options.camera = read.camera;
  const synthetic::SyntheticSequence rendered = synthetic::synthesize (options);
  EXPECT_EQ (cv::norm (read.color, rendered.frames[0].color, cv::NORM_INF), 0.0);
}

TEST_F (SynthesizeTool, TumOfAnotherSizeSaysItsCamera)
{
  for (const auto& [folder, size] :
       {std::pair{"small", " --width 160 --height 120"}, std::pair{"like_fr1", ""}}) {
    const ToolRun made =
        run ("synthesize", folder_ (folder) + " --layout tum --frames 1" + size);
    ASSERT_EQ (made.status, 0) << made.err;
    EXPECT_THAT (made.out,
                 HasSubstr (*size ? "--camera 131.2,131.2,79.5,59.5\n"
                                  : "--camera 525,525,319.5,239.5\n"));
  }
}

} // namespace
