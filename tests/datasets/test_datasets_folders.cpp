// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "support/expect_io_error.h"
#include "support/format_bytes.h"
#include "support/small_sequence.h"
#include <pcl_msf/io/datasets.h>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using io::openDataset;

void
putFrame (const std::string& color, const std::string& depth, int number)
{
  putImage (color, cv::Mat (24, 32, CV_8UC3, cv::Scalar (number)));
  putImage (depth, cv::Mat (24, 32, CV_16UC1, cv::Scalar (1000 * number)));
}

TEST (Folder, PairsSortedImages)
{
  const TemporaryFolder folder;
  for (int k : {1, 2, 10}) {
    const std::string number = std::to_string (k);
    putFrame (
        folder ("a/rgb/" + number + ".png"), folder ("a/depth/" + number + ".png"), k);
    putFrame (folder ("b/color_" + number + ".png"),
              folder ("b/depth_" + number + ".png"),
              k);
    putFrame (folder ("c/frame-" + number + ".color.png"),
              folder ("c/frame-" + number + ".depth.png"),
              k);
  }
  io::DatasetOptions options;
  options.camera = PinholeCamera{30.0, 30.0, 15.5, 11.5};
  options.depth_scale = 2000.0;
  const auto sequences = openDataset (io::DatasetKind::Automatic, folder (""), options);
  ASSERT_EQ (sequences.size(), 3u);
  EXPECT_EQ (openDataset (io::DatasetKind::Folder, folder (""), options).size(), 3u);
  for (const auto& sequence : sequences) {
    ASSERT_EQ (sequence->frames(), 3) << sequence->name();
    const io::RgbdImages last = sequence->frame (2);
    EXPECT_EQ (last.color.at<cv::Vec3b> (4, 4)[0], 10);
    EXPECT_FLOAT_EQ (last.depth.at<float> (4, 4), 5.0F);
    EXPECT_EQ (last.camera.fx, 30.0);
    EXPECT_FALSE (sequence->cameraPose (0));
  }
  EXPECT_EQ (sequences[2]->name(), "c");
}

TEST (Folder, PairsByTimesInTheNames)
{
  const TemporaryFolder folder;
  putFrame (folder ("rgb/7.100.png"), folder ("depth/7.105.png"), 1);
  putFrame (folder ("rgb/7.133.png"), folder ("depth/7.170.png"), 2);
  putFrame (folder ("rgb/7.166.png"), folder ("depth/7.300.png"), 3);
  putText (folder ("camera.txt"), "30 30 15.5 11.5 32 24 1000\n");
  const auto sequence = openDataset (io::DatasetKind::Folder, folder ("")).front();
  ASSERT_EQ (sequence->frames(), 2);
  EXPECT_NEAR (sequence->timestamp (1), 7.166, 1e-9);
  EXPECT_EQ (sequence->frame (1).color.at<cv::Vec3b> (0, 0)[0], 3);
  EXPECT_FLOAT_EQ (sequence->frame (1).depth.at<float> (0, 0), 2.0F);
  io::DatasetOptions options;
  options.max_time_difference = 0.001;
  expectIoError ([&] { openDataset (io::DatasetKind::Folder, folder (""), options); },
                 folder (""),
                 "frames");
}

TEST (Folder, TakesCameraFilesAndDepthAlone)
{
  const TemporaryFolder folder;
  putTagged (folder ("depth/1.dpt"), cv::Mat (24, 32, CV_32FC1, 1.5));
  putText (folder ("camera.txt"), "30 30 15.5 11.5 32 24 1000\n");
  const auto sequence = openDataset (io::DatasetKind::Folder, folder ("")).front();
  EXPECT_TRUE (sequence->frame (0).color.empty());
  EXPECT_FLOAT_EQ (sequence->frame (0).depth.at<float> (0, 0), 1.5F);
  EXPECT_THROW (sequence->frame (1), InvalidInput);
  EXPECT_THROW (sequence->frame (-1), InvalidInput);
}

TEST (Folder, NamesWhatIsMissing)
{
  const TemporaryFolder folder;
  const auto open = [&] {
    openDataset (io::DatasetKind::Folder, folder (""))[0]->frame (0);
  };
  putFrame (folder ("rgb/1.png"), folder ("depth/1.png"), 1);
  expectIoError (open, "camera.txt", "camera: no such file");
  putText (folder ("camera.txt"), "30 30 15.5 11.5 32 25 1000\n");
  expectIoError (open, "depth/1.png", "width, height");
  putText (folder ("camera.txt"), "30 30 15.5\n");
  expectIoError (open, "camera.txt", "cy");
  std::filesystem::remove (folder ("camera.txt"));
  expectIoError (
      [&] { openDataset (io::DatasetKind::Folder, folder (""), withCamera()); },
      "camera.txt",
      "depth_scale: unknown");
  putImage (folder ("rgb/2.png"), cv::Mat (24, 32, CV_8UC3, 1.0));
  expectIoError (open, folder (""), "frames: 2 colour and 1 depth");
}

TEST (Folder, NamesImagesWithoutAPartner)
{
  const TemporaryFolder folder;
  putFrame (folder ("color_1.png"), folder ("depth_1.png"), 1);
  putFrame (folder ("color_2.png"), folder ("depth_3.png"), 2);
  putText (folder ("camera.txt"), "30 30 15.5 11.5 32 24 1000\n");
  expectIoError ([&] { openDataset (io::DatasetKind::Folder, folder ("")); },
                 "color_2.png",
                 "depth_3.png");
}

/** An organized cloud of a wall at z metres, as text. */
void
putCloud (const std::string& path, double z)
{
  std::ostringstream text;
  text << "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 32\n"
          "HEIGHT 24\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 768\nDATA ascii\n";
  for (int v = 0; v < 24; ++v)
    for (int u = 0; u < 32; ++u)
      text << z * (u - 15.5) / 40.0 << ' ' << z * (v - 11.5) / 40.0 << ' ' << z << '\n';
  putText (path, text.str());
}

TEST (Clouds, AreSortedAndShareACamera)
{
  const TemporaryFolder folder;
  putCloud (folder ("scan_2.pcd"), 2.0);
  putCloud (folder ("scan_10.pcd"), 3.0);
  const auto sequence = openDataset (io::DatasetKind::Automatic, folder ("")).front();
  ASSERT_EQ (sequence->frames(), 2);
  EXPECT_NEAR (sequence->frame (1).camera.fx, 40.0, 1e-3);
  EXPECT_FLOAT_EQ (sequence->frame (0).depth.at<float> (3, 3), 2.0F);
  EXPECT_FLOAT_EQ (sequence->frame (1).depth.at<float> (3, 3), 3.0F);
  EXPECT_TRUE (sequence->frame (1).color.empty());
  io::DatasetOptions options;
  options.camera = PinholeCamera{41.0, 41.0, 15.0, 11.0};
  EXPECT_EQ (openDataset (io::DatasetKind::Clouds, folder (""), options)[0]
                 ->frame (0)
                 .camera.fx,
             41.0);
  const std::string bytes = readFile (folder ("scan_10.pcd"));
  putText (folder ("scan_10.pcd"), bytes.substr (0, 300));
  expectIoError ([&] { sequence->frame (1); }, "scan_10.pcd", "points");
  EXPECT_THROW (sequence->frame (2), InvalidInput);
}

} // namespace
