// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/io/pcd_grabber.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include "common/command_line.h"
#include "common/player/frame_player.h"
#include "common/player/grabber_source.h"
#include "support/temporary_folder.h"
#include "support/wall_cloud.h"
#include <gmock/gmock.h>
#include <pcl_msf/errors.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

// Any pcl::Grabber as the source of a stream.

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using ::testing::HasSubstr;

/** Gives some clouds when it starts, in no other thread, and then has ended. */
template <typename PointT>
class SmallGrabber : public pcl::Grabber {
public:
  using Cloud = pcl::PointCloud<PointT>;

  explicit SmallGrabber (std::vector<Cloud> clouds)
  : clouds_ (std::move (clouds)), signal_ (createSignal<Signal>())
  {}
  void
  start () override
  {
    for (const Cloud& cloud : clouds_)
      (*signal_) (pcl::make_shared<Cloud> (cloud));
  }
  void
  stop () override
  {}
  std::string
  getName () const override
  {
    return "SmallGrabber";
  }
  bool
  isRunning () const override
  {
    return false;
  }
  float
  getFramesPerSecond () const override
  {
    return 30.0F;
  }

private:
  using Signal = void (const typename Cloud::ConstPtr&);
  std::vector<Cloud> clouds_;
  boost::signals2::signal<Signal>* signal_;
};

/** What comes out of a grabber. */
class GrabberSources : public ::testing::Test {
protected:
  void
  open (std::unique_ptr<pcl::Grabber> grabber)
  {
    source_ = std::make_unique<tool::GrabberSource> (
        std::move (grabber), "camera 7", settings_, [this] (const std::string& text) {
          warnings_ += text + "\n";
        });
  }
  template <typename PointT>
  void
  open (std::vector<pcl::PointCloud<PointT>> clouds)
  {
    open (std::make_unique<SmallGrabber<PointT>> (std::move (clouds)));
  }
  void
  deliver ()
  {
    source_->deliver (queue_, [] { return false; });
    queue_.close();
  }
  template <typename Error>
  void
  expectError (const std::string& words)
  {
    try {
      deliver();
      ADD_FAILURE() << "no error";
    }
    catch (const Error& e) {
      EXPECT_THAT (e.what(), HasSubstr (words));
    }
  }

  tool::PlayerSettings settings_;
  tool::FrameSource::Queue queue_{8};
  std::string warnings_;
  std::unique_ptr<tool::GrabberSource> source_;
};

TEST_F (GrabberSources, MakeFramesOfCloudsAndTellTheirCamera)
{
  auto first = wall<pcl::PointXYZI>(), second = first;
  first.header.stamp = 2500000;
  second.header.stamp = 2600000;
  for (auto& point : second)
    point.intensity = 40.0F;
  open<pcl::PointXYZI> ({first, second});
  deliver();
  auto frame = queue_.pop();
  ASSERT_TRUE (frame);
  EXPECT_EQ (frame->index, 0);
  EXPECT_DOUBLE_EQ (frame->seconds, 2.5);
  EXPECT_NEAR (frame->images.camera.fx, kCamera.fx, 0.01);
  EXPECT_EQ (frame->images.depth.at<float> (8, 9), first (9, 8).z);
  frame = queue_.pop();
  ASSERT_TRUE (frame);
  EXPECT_EQ (frame->index, 1);
  EXPECT_DOUBLE_EQ (frame->seconds, 2.6);
  EXPECT_FALSE (queue_.pop());
  EXPECT_EQ (queue_.dropped(), 0);
}

TEST_F (GrabberSources, QueueDropsTheOldestAndCounts)
{
  open (std::vector<pcl::PointCloud<pcl::PointXYZ>> (20, wall<pcl::PointXYZ>()));
  deliver();
  EXPECT_EQ (queue_.dropped(), 12);
  const auto frame = queue_.pop();
  ASSERT_TRUE (frame);
  EXPECT_EQ (frame->index, 12);
  EXPECT_THAT (warnings_, HasSubstr ("no colour"));
}

TEST_F (GrabberSources, FirstCloudMustBeRightLaterOnesAreLost)
{
  const auto whole = wall<pcl::PointXYZRGB>();
  auto bare = whole;
  bare.width *= bare.height;
  bare.height = 1;
  open<pcl::PointXYZRGB> ({bare, whole});
  expectError<InvalidInput> ("organized");
  queue_.close();
  EXPECT_FALSE (queue_.pop());
}

TEST_F (GrabberSources, LaterCloudsMayBeLost)
{
  const auto whole = wall<pcl::PointXYZRGB>();
  open<pcl::PointXYZRGB> ({whole, {}, whole});
  deliver();
  for (const bool good : {true, false, true}) {
    const auto frame = queue_.pop();
    ASSERT_TRUE (frame);
    EXPECT_EQ (frame->problem.empty(), good);
  }
}

TEST_F (GrabberSources, WithoutCloudsSayTheCameraAndTheRemedy)
{
  open<pcl::PointXYZ> ({});
  expectError<tool::UsageError> ("camera 7: gives no clouds; see");
  open (std::make_unique<SmallGrabber<pcl::PointXY>> (
      std::vector<pcl::PointCloud<pcl::PointXY>>{}));
  expectError<tool::UsageError> ("camera 7: gives no clouds of points");
}

/** PCL's own, whose thread calls back. */
class ThreadedGrabber : public GrabberSources {
protected:
  void
  openFiles (int frames, bool repeat)
  {
    std::vector<std::string> files;
    for (int k = 0; k < frames; ++k) {
      files.push_back (folder_ (std::to_string (k) + ".pcd"));
      pcl::io::savePCDFileBinary (files.back(), wall<pcl::PointXYZRGBA>());
    }
    open (std::make_unique<pcl::PCDGrabber<pcl::PointXYZRGBA>> (files, 100.0F, repeat));
  }
  TemporaryFolder folder_;
};

TEST_F (ThreadedGrabber, EndsWithItsFiles)
{
  openFiles (3, false);
  deliver();
  for (int k = 0; k < 3; ++k) {
    const auto frame = queue_.pop();
    ASSERT_TRUE (frame);
    EXPECT_EQ (frame->index, k);
  }
  EXPECT_FALSE (queue_.pop());
}

TEST_F (ThreadedGrabber, EndsWhenNobodyWantsMore)
{
  openFiles (2, true);
  {
    tool::FramePlayer player (*source_, queue_);
    for (int k = 0; k < 5; ++k)
      ASSERT_TRUE (queue_.pop());
    player.requireFrames(); // stops an endless stream
  }
  while (queue_.pop()) { // what waits
  }
}

} // namespace
