// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "scene_flow/options.h"
#include "support/temporary_folder.h"
#include <CLI/App.hpp>
#include <CLI/Formatter.hpp>
#include <gmock/gmock.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;

const std::string kImages =
    "--color a --depth b --color c --depth d --camera 150,151,79.5,59.5 --output o ";

Options
parse (const std::string& line)
{
  std::istringstream stream (line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    words.push_back (word);
  Options options;
  CLI::App app;
  declareOptions (app, options);
  readCommandLine (app, words);
  return options;
}

void
expectUsageError (const std::string& line, const std::string& start)
{
  try {
    parse (line);
    ADD_FAILURE() << "taken: " << line;
  }
  catch (const UsageError& e) {
    EXPECT_THAT (e.what(), ::testing::StartsWith (start));
    EXPECT_THAT (e.what(), ::testing::Not (::testing::HasSubstr ("\n")));
  }
}

TEST (SceneFlowOptions, WritesWhatIsAskedFor)
{
  EXPECT_EQ (parse (kImages).outputs.size(), 7u);
  const Options some = parse (kImages + "--outputs flow,cloud");
  EXPECT_TRUE (some.wants (Output::Flow) && some.wants (Output::Cloud));
  for (const Output other : {Output::Warped,
                             Output::Visibility,
                             Output::Labels,
                             Output::Poses,
                             Output::Pictures})
    EXPECT_FALSE (some.wants (other));
  for (const char* wrong : {",", "flo", "flow;cloud"})
    expectUsageError (kImages + "--outputs " + wrong, "--outputs: ");
}

TEST (SceneFlowOptions, TakesTheContractsLine)
{
  const Options o = parse (kImages + "--depth-scale 5000");
  EXPECT_EQ (o.color, (std::vector<std::string>{"a", "c"}));
  EXPECT_EQ (o.depth, (std::vector<std::string>{"b", "d"}));
  EXPECT_EQ (o.camera->fy, 151.0);
  EXPECT_EQ (o.camera->cx, 79.5);
  EXPECT_EQ (*o.depth_scale, 5000.0);
  EXPECT_EQ (o.output, "o");
  EXPECT_FALSE (o.quiet);
  EXPECT_FALSE (parse ("--cloud a --cloud b --output o").camera.has_value());
}

TEST (SceneFlowOptions, ReachesTheParameters)
{
  const Options o =
      parse (kImages +
             "--smoothing-sigma 1.5 --min-depth .3 --max-depth=9 --max-levels 3 "
             "--normals integral --segmentation slic --threshold 0.7 --min-points 50 "
             "--discard-small 1 --segment-size 32 --brightness-weight 2 --icp-weight 3 "
             "--regularizer-weight 4 --prior-weight 5 --huber-threshold 6 --loss l2 "
             "--pose-difference parameters --neighbors 7 --max-iterations 8 "
             "--function-tolerance 1e-4 --parameter-tolerance 1e-5 --max-seconds 9 "
             "--linear-solver cholesky --levels 2 --flow-proposals 0 --blend-motions 0 "
             "--refine-flow 0 --merge-bodies 0 --threads 5 --flow-max 12 --quiet");
  EXPECT_EQ (o.frame.smoothing_sigma, 1.5);
  EXPECT_EQ (o.frame.min_depth, 0.3);
  EXPECT_EQ (o.frame.max_depth, 9.0);
  EXPECT_EQ (o.frame.max_levels, 3);
  EXPECT_EQ (o.frame.normals, NormalMethod::IntegralImage);
  EXPECT_EQ (o.segmentation.method, SegmentationMethod::Slic);
  EXPECT_EQ (o.segmentation.threshold, 0.7);
  EXPECT_EQ (o.segmentation.min_points, 50);
  EXPECT_TRUE (o.segmentation.discard_small);
  EXPECT_EQ (o.segmentation.segment_size, 32);
  EXPECT_EQ (o.energy.brightness_weight, 2.0);
  EXPECT_EQ (o.energy.icp_weight, 3.0);
  EXPECT_EQ (o.energy.regularizer_weight, 4.0);
  EXPECT_EQ (o.energy.prior_weight, 5.0);
  EXPECT_EQ (o.energy.huber_threshold, 6.0);
  EXPECT_EQ (o.energy.loss, LossType::L2);
  EXPECT_EQ (o.energy.pose_difference, PoseDifference::Parameters);
  EXPECT_EQ (o.energy.neighbors, 7);
  EXPECT_EQ (o.solver.max_iterations, 8);
  EXPECT_EQ (o.solver.function_tolerance, 1e-4);
  EXPECT_EQ (o.solver.parameter_tolerance, 1e-5);
  EXPECT_EQ (o.solver.max_seconds, 9.0);
  EXPECT_EQ (o.solver.linear_solver, LinearSolver::SparseCholesky);
  EXPECT_EQ (o.solver.levels, 2);
  EXPECT_FALSE (o.solver.flow_proposals);
  EXPECT_FALSE (o.solver.blend_motions);
  EXPECT_FALSE (o.solver.refine_flow);
  EXPECT_FALSE (o.solver.merge_bodies);
  EXPECT_EQ (o.solver.threads, 5U);
  EXPECT_EQ (o.flow_maximum, 12.0);
  EXPECT_TRUE (o.quiet);
  EXPECT_EQ (parse (kImages + "--labels l").labels, "l");
}

TEST (SceneFlowOptions, ListsThatAreGivenAgainAreJoined)
{
  const Options o = parse (kImages + "--outputs flow --outputs cloud,poses");
  EXPECT_EQ (o.outputs,
             (std::vector<Output>{Output::Flow, Output::Cloud, Output::Poses}));
  expectUsageError (kImages + "--outputs flow --outputs flo", "--outputs: 'flow,flo'");
}

TEST (SceneFlowOptions, OneThingChoosesTheSegments)
{
  const std::string rigid = kImages + "--rigid --segmentation ";
  expectUsageError (kImages + "--labels l --segmentation slic",
                    "--labels excludes --segmentation");
  expectUsageError (kImages + "--labels l --rigid", "--labels excludes --rigid");
  expectUsageError (rigid + "slic", "--rigid: not together with --segmentation");
  EXPECT_EQ (parse (rigid + "single").segmentation.method, SegmentationMethod::Single);
}

/** Shards of one run are known by them. */
TEST (SceneFlowOptions, SettingsHaveThePlacesOfFiles)
{
  const pcl_msf::testing::TemporaryFolder folder;
  std::filesystem::create_directory (folder ("rec"));
  const std::string one = parse (folder ("rec") + " --window 2").settings;
  EXPECT_THAT (
      one, ::testing::HasSubstr (std::filesystem::canonical (folder ("rec")).string()));
  for (const char* other : {"rec/", "rec/.", "rec/../rec", "./rec"})
    EXPECT_EQ (parse (folder (other) + " --window 2").settings, one) << other;
  const std::string relative = std::filesystem::relative (folder ("rec")).string();
  EXPECT_EQ (parse (relative + " --window 2").settings, one) << relative;
  EXPECT_NE (parse (folder ("rec") + " --window 3").settings, one);
  const std::string camera = " --camera 9,9,9,9 --output o";
  EXPECT_EQ (parse ("--depth a --depth b/../c" + camera).settings,
             parse ("--depth ./a --depth c" + camera).settings);
}

TEST (SceneFlowOptions, NamesWhatItRefuses)
{
  expectUsageError (kImages + "stray", "'stray'");
  expectUsageError (kImages + "--colour x", "--colour: no such option");
  expectUsageError (kImages + "--threads", "--threads: needs a value");
  expectUsageError (kImages + "--threads two", "--threads: 'two'");
  expectUsageError (kImages + "--threads -1", "--threads: '-1'");
  expectUsageError (kImages + "--levels 2.5", "--levels: '2.5'");
  expectUsageError (kImages + "--levels 99", "--levels");
  expectUsageError (kImages + "--loss l3", "--loss: 'l3'");
  expectUsageError (kImages + "--merge-bodies yes", "--merge-bodies: 'yes'");
  expectUsageError (kImages + "--prior-weight nan", "--prior-weight: 'nan'");
  expectUsageError (kImages + "--prior-weight -1", "--prior-weight must be");
  expectUsageError (kImages + "--brightness-weight 0 --icp-weight 0",
                    "--brightness-weight, --icp-weight: both are 0");
  expectUsageError (kImages + "--quiet=maybe", "--quiet");
  expectUsageError (kImages + "--labels=", "--labels: needs a value");
  expectUsageError (kImages + "--camera 150,150,79.5", "--camera: '150,150,79.5'");
  expectUsageError (kImages + "--camera 1,2,3,4,5", "--camera: '1,2,3,4,5'");
  expectUsageError (kImages + "--camera 1,2,3,", "--camera: '1,2,3,'");
  expectUsageError (kImages + "--depth-scale 0", "--depth-scale: '0'");
  expectUsageError (kImages + "--flow-max -1", "--flow-max");
}

TEST (SceneFlowOptions, WantsTwoFramesAndAFolder)
{
  expectUsageError (kImages + "--cloud x.pcd", "--color excludes --cloud");
  expectUsageError (kImages + "--color x", "--color: given 3 times");
  expectUsageError ("seq --track --reference 1", "--reference excludes --track");
  expectUsageError ("seq --window 1", "--window: 1");
  expectUsageError ("--depth a --camera 9,9,9,9 --output o", "--depth: given 1 times");
  expectUsageError ("--cloud a --output o", "--cloud: given 1 times");
  expectUsageError ("--cloud a --cloud b", "--output: missing");
  expectUsageError ("--depth a --depth b --output o", "--camera: missing");
}

TEST (SceneFlowOptions, HelpHasEveryOptionWithItsDefault)
{
  Options options;
  options.energy.neighbors = 17; // whatever the struct holds
  CLI::App app;
  declareOptions (app, options);
  for (const CLI::Option* option : app.get_options())
    EXPECT_FALSE (option->get_description().empty()) << option->get_name();
  EXPECT_EQ (app.get_option ("--neighbors")->get_default_str(), "17");
  EXPECT_EQ (app.get_option ("--loss")->get_default_str(), "huber");
  EXPECT_EQ (app.get_option ("--merge-bodies")->get_default_str(), "1");
}

} // namespace
