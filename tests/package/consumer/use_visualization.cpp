// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/visualization/offscreen_renderer.h>

int
main ()
{
  using namespace pcl_msf::visualization;
  Scene scene;
  const cv::Mat positions (1, 1, CV_32FC3, cv::Scalar (0, 0, 1));
  scene.points.push_back ({positions, cv::Mat (1, 1, CV_8UC3, cv::Scalar (0, 0, 255))});
  PictureStyle style;
  style.size = {64, 48};
  style.axes = false;
  OffscreenRenderer renderer;
  const cv::Mat picture =
      renderer.render (scene, sensorView ({60, 60, 32, 24}, style.size), style);
  return picture.at<cv::Vec3b> (24, 32) == cv::Vec3b (0, 0, 255) ? 0 : 1;
}
