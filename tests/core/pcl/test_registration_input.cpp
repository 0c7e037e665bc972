// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/rigid_pair.h"
#include <gmock/gmock.h>
#include <pcl_msf/piecewise_rigid_registration.h>

#include <cmath>
#include <cstring>

namespace {

using namespace pcl_msf;
using testing::HasSubstr;

using Point = pcl::PointXYZRGB;
using Cloud = pcl::PointCloud<Point>;
using Registration = PiecewiseRigidRegistration<Point>;

/** One way to spoil a registration that would work, and what the message must name. */
struct BadInput {
  const char* name;
  const char* remedy;
  std::function<void (Registration&, Eigen::Matrix4f& guess)> spoil;
};

void
PrintTo (const BadInput& input, std::ostream* out)
{
  *out << input.name;
}

Cloud::Ptr
cloudOf (std::uint32_t width, std::uint32_t height, float z)
{
  const auto cloud = pcl::make_shared<Cloud> (width, height);
  for (Point& p : *cloud)
    p.z = z;
  return cloud;
}

Cloud::Ptr
changed (Cloud::Ptr cloud, const std::function<void (Point&)>& change)
{
  for (Point& p : *cloud)
    change (p);
  return cloud;
}

pcl::IndicesPtr
indicesOf (pcl::Indices indices)
{
  return pcl::make_shared<pcl::Indices> (std::move (indices));
}

class BadInputs : public testing::TestWithParam<BadInput> {};

TEST_P (BadInputs, AreRefusedWithTheRemedyAndWithoutAThrow)
{
  Registration registration;
  const Cloud::Ptr reference = RigidPair::reference();
  registration.setInputSource (reference);
  registration.setInputTarget (RigidPair::current());
  Cloud output;
  registration.align (output); // it works before
  ASSERT_TRUE (registration.hasConverged());

  Eigen::Matrix4f guess = Eigen::Matrix4f::Identity();
  testing::internal::CaptureStderr();
  GetParam().spoil (registration, guess);
  pcl::Registration<Point, Point>& base = registration;
  ASSERT_NO_THROW (base.align (output, guess));
  const std::string printed = testing::internal::GetCapturedStderr();

  EXPECT_THAT (printed, HasSubstr ("[pcl_msf::PiecewiseRigidRegistration::align]"));
  EXPECT_THAT (printed, HasSubstr (GetParam().remedy));
  EXPECT_FALSE (base.hasConverged());
  EXPECT_EQ (base.getFinalTransformation(), Eigen::Matrix4f::Identity());
  EXPECT_EQ (registration.getReport().stop_reason, StopReason::InvalidInput);
  EXPECT_THAT (printed, HasSubstr (registration.getReport().message));
  EXPECT_TRUE (registration.getSceneFlow().displacement.empty());
  EXPECT_EQ (registration.getFitnessScore(), std::numeric_limits<double>::max());
  const auto source = registration.getInputSource();
  if (registration.getIndices()->size() != source->size())
    return;
  EXPECT_EQ (output.width, source->width);
  EXPECT_EQ (output.height, source->height);
  for (std::size_t i = 0; i < source->size(); ++i)
    ASSERT_EQ (std::memcmp (&(*source)[i], &output[i], 3 * sizeof (float)), 0) << i;
}

const float nan_value = std::nanf ("");

const BadInput bad_inputs[] = {
    {"NoSource",
     "setInputSource",
     [] (Registration& r, auto&) { r.setInputSource (nullptr); }},
    {"NoTarget",
     "setInputTarget",
     [] (Registration& r, auto&) { r.setInputTarget (nullptr); }},
    {"EmptySource",
     "give an organized cloud",
     [] (Registration& r, auto&) { r.setInputSource (cloudOf (0, 0, 1.0f)); }},
    {"EmptyTarget",
     "give an organized cloud",
     [] (Registration& r, auto&) { r.setInputTarget (cloudOf (0, 0, 1.0f)); }},
    {"UnorganizedSource",
     "setKeepOrganized",
     [] (Registration& r, auto&) {
       r.setCorrespondence (CorrespondenceMethod::Projective);
       r.setInputSource (cloudOf (160 * 120, 1, 1.0f));
     }},
    {"UnorganizedTarget",
     "setKeepOrganized",
     [] (Registration& r, auto&) {
       r.setCorrespondence (CorrespondenceMethod::Projective);
       r.setInputTarget (cloudOf (160 * 120, 1, 1.0f));
     }},
    {"NoSurface", // all points at one place
     "give a surface",
     [] (Registration& r, auto&) { r.setInputSource (cloudOf (160 * 120, 1, 1.0f)); }},
    {"OtherSize",
     "clouds of one size",
     [] (Registration& r, auto&) { r.setInputTarget (cloudOf (80, 60, 1.0f)); }},
    {"NoDepthInSource",
     "z must be positive",
     [] (Registration& r, auto&) { r.setInputSource (cloudOf (160, 120, nan_value)); }},
    {"NoDepthInTarget",
     "z must be positive",
     [] (Registration& r, auto&) { r.setInputTarget (cloudOf (160, 120, -1.0f)); }},
    {"CameraUnknown", // all x and y are zero
     "fill x and y",
     [] (Registration& r, auto&) { r.setInputSource (cloudOf (160, 120, 1.0f)); }},
    {"CameraAbsurd",
     "by setCamera",
     [] (Registration& r, auto&) {
       r.setCamera ({1e7, 1e7, 80.0, 60.0});
     }},
    {"TargetOfAnotherCamera",
     "clouds of one camera",
     [] (Registration& r, auto&) {
       const auto wide = pcl::make_shared<Cloud> (*RigidPair::current());
       for (Point& p : *wide)
         p.x *= 2.0f;
       r.setInputTarget (wide);
     }},
    {"CameraOfAnotherResolution",
     "0.5 times the focal length",
     [] (Registration& r, auto&) {
       r.setCamera ({300.0, 304.0, 159.5, 119.5});
     }},
    {"MirroredWithACamera",
     "the source is no image of the camera",
     [] (Registration& r, auto&) {
       r.setCamera (RigidPair::camera());
       r.setInputSource (
           changed (RigidPair::reference(), [] (Point& p) { p.x *= -1; }));
     }},
    {"TargetMovedWithACamera",
     "the target is no image of the camera",
     [] (Registration& r, auto&) {
       r.setCamera (RigidPair::camera());
       r.setInputTarget (changed (RigidPair::current(), [] (Point& p) { p.x += 1; }));
     }},
    {"TargetMoved",
     "the camera is at (1, ",
     [] (Registration& r, auto&) {
       r.setInputTarget (changed (RigidPair::current(), [] (Point& p) { p.x += 1; }));
     }},
    {"FlippedForAViewer",
     "y and z are flipped",
     [] (Registration& r, auto&) {
       r.setInputSource (changed (RigidPair::reference(), [] (Point& p) {
         p.y *= -1;
         p.z *= -1;
       }));
     }},
    {"Millimetres",
     "millimetres?",
     [] (Registration& r, auto&) {
       r.setInputSource (changed (RigidPair::reference(),
                                  [] (Point& p) { p.getVector3fMap() *= 1e3f; }));
     }},
    {"TooSmall",
     "is 160x11, and must be at least 12x12",
     [] (Registration& r, auto&) { r.setInputSource (cloudOf (160, 11, 1.0f)); }},
    {"LabelsOfAnotherSize",
     "clearSegmentation",
     [] (Registration& r, auto&) {
       r.setSegmentation (pcl::make_shared<pcl::PointCloud<pcl::Label>> (80, 60));
     }},
    {"NormalsOfAnotherSize",
     "setSourceNormals",
     [] (Registration& r, auto&) {
       r.setSourceNormals (pcl::make_shared<pcl::PointCloud<pcl::Normal>> (80, 60));
     }},
    {"NormalsWithoutAGrid",
     "setSourceNormals",
     [] (Registration& r, auto&) {
       r.setSourceNormals (
           pcl::make_shared<pcl::PointCloud<pcl::Normal>> (160 * 120, 1));
     }},
    {"IndexOutside",
     "setIndices",
     [] (Registration& r, auto&) {
       r.setIndices (indicesOf ({0, 160 * 120}));
     }},
    {"IndexNegative",
     "setIndices",
     [] (Registration& r, auto&) { r.setIndices (indicesOf ({-1})); }},
    {"RectangleOutside",
     "setIndices",
     [] (Registration& r, auto&) { r.setIndices (0, 0, 121, 1); }},
    {"NoIndices",
     "setIndices",
     [] (Registration& r, auto&) { r.setIndices (indicesOf ({})); }},
    {"GuessNaN",
     "rigid transformation",
     [] (Registration&, Eigen::Matrix4f& guess) { guess (0, 3) = nan_value; }},
    {"GuessZero",
     "rigid transformation",
     [] (Registration&, Eigen::Matrix4f& guess) { guess.setZero(); }},
    {"GuessMirrors",
     "rigid transformation",
     [] (Registration&, Eigen::Matrix4f& guess) { guess (0, 0) = -1.0f; }},
    {"IterationsNegativeBehindTheBase",
     "max_iterations",
     [] (pcl::Registration<Point, Point>& r, auto&) { r.setMaximumIterations (-1); }},
};

INSTANTIATE_TEST_SUITE_P (All,
                          BadInputs,
                          testing::ValuesIn (bad_inputs),
                          [] (const auto& info) { return info.param.name; });

TEST (Registration, AlignWithoutAnyInputFailsVisibly)
{
  Registration registration;
  Cloud output;
  std::function<Registration::UpdateVisualizerCallbackSignature> callback =
      [] (auto&, auto&, auto&, auto&) {};
  testing::internal::CaptureStderr();
  registration.registerVisualizationCallback (callback);
  registration.align (output);
  EXPECT_THAT (testing::internal::GetCapturedStderr(), HasSubstr ("setInputSource"));
  EXPECT_FALSE (registration.hasConverged());
  EXPECT_TRUE (registration.getInputSource()->empty());
}

TEST (Registration, RecoversAfterBadInput)
{
  Registration registration;
  Cloud output;
  registration.setInputSource (RigidPair::reference());
  testing::internal::CaptureStderr();
  registration.setInputTarget (nullptr);
  registration.align (output);
  testing::internal::GetCapturedStderr();
  registration.setInputTarget (RigidPair::current());
  registration.align (output);
  EXPECT_TRUE (registration.hasConverged());
  EXPECT_EQ (registration.getReport().message, "");
}

TEST (Registration, IndicesAndSourceComeInAnyOrder)
{
  Registration registration;
  registration.setIndices (indicesOf ({100, 200, 300}));
  registration.setInputSource (RigidPair::reference());
  registration.setInputTarget (RigidPair::current());
  Cloud output;
  registration.align (output);
  EXPECT_EQ (output.size(), 3u);
  EXPECT_EQ (registration.getReport().message, "");
}

} // namespace
