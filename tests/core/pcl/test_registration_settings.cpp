// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <pcl_msf/piecewise_rigid_registration.h>

#include <cmath>

namespace {

using namespace pcl_msf;
using testing::HasSubstr;

using Registration = PiecewiseRigidRegistration<pcl::PointXYZ>;

const double nan_value = std::nan ("");

/** Runs a call that must be refused; returns what it printed. */
template <typename Call>
std::string
refused (const char* method, Call call)
{
  testing::internal::CaptureStderr();
  call();
  const std::string printed = testing::internal::GetCapturedStderr();
  EXPECT_THAT (printed,
               HasSubstr (std::string ("[pcl_msf::PiecewiseRigidRegistration::") +
                          method + "] "));
  return printed;
}

TEST (RegistrationSettings, CameraIsKeptAndBadOnesAreRefused)
{
  Registration r;
  EXPECT_EQ (r.getCamera().fx, 0.0);
  r.setCamera ({525.0, 526.0, 319.5, 239.5});
  for (const PinholeCamera& bad : {PinholeCamera{},
                                   PinholeCamera{-525.0, 525.0, 320.0, 240.0},
                                   PinholeCamera{525.0, nan_value, 320.0, 240.0},
                                   PinholeCamera{525.0, 525.0, INFINITY, 240.0}})
    refused ("setCamera", [&] { r.setCamera (bad); });
  EXPECT_EQ (r.getCamera().fy, 526.0);
  r.clearCamera();
  EXPECT_EQ (r.getCamera().fx, 0.0);
}

TEST (RegistrationSettings, FrameParameters)
{
  Registration r;
  FrameParameters p;
  p.max_depth = 8.0;
  r.setFrameParameters (p);
  p.smoothing_sigma = nan_value;
  EXPECT_THAT (refused ("setFrameParameters", [&] { r.setFrameParameters (p); }),
               HasSubstr ("[0, 10]"));
  EXPECT_EQ (r.getFrameParameters().max_depth, 8.0);
  EXPECT_EQ (r.getFrameParameters().smoothing_sigma, FrameParameters{}.smoothing_sigma);
}

TEST (RegistrationSettings, SegmentationParameters)
{
  Registration r;
  SegmentationParameters p;
  p.min_points = 500;
  r.setSegmentationParameters (p);
  p.threshold = nan_value;
  refused ("setSegmentationParameters", [&] { r.setSegmentationParameters (p); });
  EXPECT_EQ (r.getSegmentationParameters().min_points, 500);
  p = {};
  p.segment_size = 40;
  r.setSegmentationParameters (p);
  p.segment_size = 3;
  EXPECT_THAT (
      refused ("setSegmentationParameters", [&] { r.setSegmentationParameters (p); }),
      HasSubstr ("[4, 512]"));
  r.setSegmentationMethod (SegmentationMethod::Slic);
  refused ("setSegmentationMethod",
           [&] { r.setSegmentationMethod (static_cast<SegmentationMethod> (77)); });
  EXPECT_EQ (r.getSegmentationMethod(), SegmentationMethod::Slic);
  EXPECT_EQ (r.getSegmentationParameters().segment_size, 40);
}

TEST (RegistrationSettings, EnergyParameters)
{
  Registration r;
  EnergyParameters p;
  p.icp_weight = 2.0;
  r.setEnergyParameters (p);
  p.prior_weight = 0.0;
  refused ("setEnergyParameters", [&] { r.setEnergyParameters (p); });
  EXPECT_EQ (r.getEnergyParameters().icp_weight, 2.0);
  p = {};
  for (const double bad : {-1.0, nan_value}) {
    p.regularizer_weight = bad;
    refused ("setEnergyParameters", [&] { r.setEnergyParameters (p); });
  }
  EXPECT_EQ (r.getEnergyParameters().icp_weight, 2.0);
}

TEST (RegistrationSettings, SolverParameters)
{
  Registration r;
  SolverParameters p;
  p.levels = 2;
  p.max_iterations = 6;
  r.setSolverParameters (p);
  p.function_tolerance = nan_value;
  refused ("setSolverParameters", [&] { r.setSolverParameters (p); });
  EXPECT_EQ (r.getSolverParameters().levels, 2);
  refused ("setMaximumIterations", [&] { r.setMaximumIterations (-1); });
  EXPECT_EQ (r.getMaximumIterations(), 6);
  r.setMaximumIterations (4);
  EXPECT_EQ (r.getSolverParameters().max_iterations, 4);
  p = {};
  p.max_seconds = 0.5;
  p.progress = [] (const Progress&) { return true; };
  r.setSolverParameters (p);
  for (const double bad : {-1.0, nan_value, double (INFINITY)}) {
    p.max_seconds = bad;
    refused ("setSolverParameters", [&] { r.setSolverParameters (p); });
  }
  EXPECT_EQ (r.getSolverParameters().max_seconds, 0.5);
  EXPECT_TRUE (r.getSolverParameters().progress);
}

/** What valid parameters say after a change that spoils them. */
template <typename Parameters, typename Change>
std::string
whyNot (const Change& spoil)
{
  Parameters parameters;
  std::string why;
  EXPECT_TRUE (parameters.isValid (&why)) << why;
  spoil (parameters);
  EXPECT_FALSE (parameters.isValid (&why));
  return why;
}

TEST (RegistrationSettings, MessagesTellTheRangeThatIsTested)
{
  for (const double bad : {1e300, double (INFINITY)})
    EXPECT_THAT (whyNot<SolverParameters> ([bad] (auto& p) { p.max_seconds = bad; }),
                 HasSubstr ("max_seconds must be in [0, 1e12] s"));
  EXPECT_THAT (whyNot<EnergyParameters> ([] (auto& p) { p.brightness_weight = 1e300; }),
               HasSubstr ("brightness_weight must be in [0, 1e12]"));
  EXPECT_THAT (
      whyNot<EnergyParameters> ([] (auto& p) { p.regularizer_weight = 1e300; }),
      HasSubstr ("regularizer_weight must be in [0, 1e12]"));
  EXPECT_THAT (whyNot<EnergyParameters> ([] (auto& p) { p.prior_weight = 1e-300; }),
               HasSubstr ("prior_weight must be in [1e-12, 1e12]"));
  EXPECT_THAT (whyNot<FrameParameters> ([] (auto& p) { p.min_depth = 1e300; }),
               HasSubstr ("min_depth must be in [0, 1e12]"));
  EXPECT_THAT (whyNot<SegmentationParameters> ([] (auto& p) { p.threshold = 0.0; }),
               HasSubstr ("threshold must be in [1e-9, 1e12]"));
}

TEST (RegistrationSettings, RefuseWhatIsNoValueOfItsEnumeration)
{
  Registration r;
  EnergyParameters energy;
  for (const int none : {9, -1}) {
    energy.loss = static_cast<LossType> (none);
    EXPECT_THAT (
        refused ("setEnergyParameters", [&] { r.setEnergyParameters (energy); }),
        HasSubstr ("loss is not a LossType"));
  }
  EXPECT_EQ (r.getEnergyParameters().loss, LossType::Huber);
  EXPECT_THAT (whyNot<EnergyParameters> ([] (auto& p) {
                 p.pose_difference = static_cast<PoseDifference> (2);
               }),
               HasSubstr ("pose_difference"));
  EXPECT_THAT (whyNot<SolverParameters> (
                   [] (auto& p) { p.linear_solver = static_cast<LinearSolver> (2); }),
               HasSubstr ("linear_solver"));
  EXPECT_THAT (whyNot<SegmentationParameters> (
                   [] (auto& p) { p.method = static_cast<SegmentationMethod> (5); }),
               HasSubstr ("method"));
  EXPECT_THAT (whyNot<FrameParameters> (
                   [] (auto& p) { p.normals = static_cast<NormalMethod> (3); }),
               HasSubstr ("normals"));
}

TEST (RegistrationSettings, Threads)
{
  Registration r;
  EXPECT_EQ (r.getNumberOfThreads(), 0u);
  r.setNumberOfThreads (2);
  refused ("setNumberOfThreads",
           [&] { r.setNumberOfThreads (static_cast<unsigned> (-1)); });
  EXPECT_EQ (r.getNumberOfThreads(), 2u);
  SolverParameters p = r.getSolverParameters();
  EXPECT_EQ (p.threads, 2u);
  p.threads = 1025;
  refused ("setSolverParameters", [&] { r.setSolverParameters (p); });
  r.setNumberOfThreads();
  EXPECT_EQ (r.getNumberOfThreads(), 0u);
}

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
TEST (RegistrationSettings, FormerShortcutsSetTheStructures)
{
  Registration r;
  r.setSegmentSize (40);
  r.setRigid (true);
  EXPECT_TRUE (r.isRigid());
  EXPECT_EQ (r.getSegmentationParameters().segment_size, 40);
  EXPECT_EQ (r.getSegmentationMethod(), SegmentationMethod::Single);
  r.setRigid (false);
  EXPECT_EQ (r.getSegmentationMethod(), SegmentationMethod::TangentPlane);
  r.setSegmentationMethod (SegmentationMethod::Slic);
  r.setRigid (false);
  EXPECT_EQ (r.getSegmentationMethod(), SegmentationMethod::Slic) << "was not rigid";
  r.setRegularizerWeight (0.5);
  EXPECT_EQ (r.getEnergyParameters().regularizer_weight, 0.5);
  r.setTimeBudget (2.0);
  r.setProgressCallback ([] (const Progress&) { return true; });
  EXPECT_EQ (r.getSolverParameters().max_seconds, 2.0);
  EXPECT_TRUE (r.getSolverParameters().progress);
  refused ("setSegmentationParameters", [&] { r.setSegmentSize (3); });
  refused ("setEnergyParameters", [&] { r.setRegularizerWeight (nan_value); });
  refused ("setTimeBudget", [&] { r.setTimeBudget (-1.0); });
  EXPECT_EQ (r.getSegmentSize(), 40);
  EXPECT_EQ (r.getRegularizerWeight(), 0.5);
  EXPECT_EQ (r.getTimeBudget(), 2.0);
  EXPECT_TRUE (r.getProgressCallback());
}
#pragma GCC diagnostic pop

TEST (RegistrationSettings, SegmentationFromOutside)
{
  Registration r;
  using Labels = pcl::PointCloud<pcl::Label>;
  const auto labels = pcl::make_shared<Labels> (4, 3);
  r.setSegmentation (labels);
  EXPECT_EQ (r.getSegmentationLabels(), labels);
  refused ("setSegmentation", [&] { r.setSegmentation (Labels::ConstPtr()); });
  refused ("setSegmentation", [&] { r.setSegmentation (pcl::make_shared<Labels>()); });
  std::vector<pcl::PointIndices> clusters (2);
  refused ("setSegmentation", [&] { r.setSegmentation (clusters); });
  EXPECT_EQ (r.getSegmentationLabels(), labels);
  clusters[1].indices = {3, 4};
  r.setSegmentation (clusters);
  EXPECT_EQ (r.getSegmentationIndices().size(), 2u);
  EXPECT_FALSE (r.getSegmentationLabels());
  r.clearSegmentation();
  EXPECT_TRUE (r.getSegmentationIndices().empty());
}

TEST (RegistrationSettings, SourceNormals)
{
  Registration r;
  using Normals = pcl::PointCloud<pcl::Normal>;
  const auto normals = pcl::make_shared<Normals> (4, 3);
  r.setSourceNormals (normals);
  refused ("setSourceNormals",
           [&] { r.setSourceNormals (pcl::make_shared<Normals>()); });
  EXPECT_EQ (r.getSourceNormals(), normals);
  const auto list = pcl::make_shared<Normals> (12, 1); // of clouds without a grid
  r.setSourceNormals (list);
  EXPECT_EQ (r.getSourceNormals(), list);
  r.setSourceNormals (nullptr);
  EXPECT_FALSE (r.getSourceNormals());
}

TEST (RegistrationSettings, ARectangleIsOfTheSourceOfTheMoment)
{
  Registration r;
  refused ("setIndices", [&] { r.setIndices (0, 0, 0, 1); });
  EXPECT_FALSE (r.getIndices());
  r.setIndices (1, 1, 2, 2);
  EXPECT_TRUE (r.getIndices()->empty()) << "no source yet";
  const auto source = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>> (4, 3);
  r.setInputSource (source);
  EXPECT_THAT (*r.getIndices(), testing::ElementsAre (5, 6, 9, 10));
  *source = pcl::PointCloud<pcl::PointXYZ> (5, 3);
  EXPECT_THAT (*r.getIndices(), testing::ElementsAre (6, 7, 11, 12));
  const std::size_t huge = std::numeric_limits<std::size_t>::max();
  r.setIndices (1, 1, huge, 1);
  EXPECT_TRUE (r.getIndices()->empty());
  r.setIndices (pcl::IndicesPtr());
  EXPECT_FALSE (r.getIndices());
}

} // namespace
