// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "support/expect_refusal.h"
#include "support/small_scene.h"
#include <gmock/gmock.h>
#include <pcl_msf/io/result_files.h>
#include <pcl_msf/io/text_files.h>

#include <filesystem>
#include <string>

namespace pcl_msf::testing {

/** \brief A folder with two frames; the tool runs without a display. */
class RenderCase : public ::testing::Test {
protected:
  RenderCase()
  {
    std::filesystem::create_directory (folder_ ("case"));
    for (int k = 0; k < 2; ++k) {
      const std::string number = std::to_string (k);
      io::writeImage (folder_ ("case/color_" + number + ".png"), SmallScene::color (k));
      io::writeDepth (
          folder_ ("case/depth_" + number + ".png"), SmallScene::depth (k), 5000.0);
    }
    io::writeCamera (folder_ ("case/camera.txt"),
                     {scene_.camera, SmallScene::kWidth, SmallScene::kHeight, 5000.0});
  }
  ToolRun
  run (const std::string& arguments) const
  {
    return runTool (folder_, "env -u DISPLAY " + tool_ + " " + arguments);
  }
  void
  expectRefusal (const std::string& arguments, const std::string& words) const
  {
    testing::expectRefusal (run (arguments), arguments, {words});
  }
  cv::Mat
  picture (const std::string& name) const
  {
    return cv::imread (folder_ ("out/" + name), cv::IMREAD_COLOR);
  }

  /** A stored result of the case, as pcl_msf_scene_flow writes it.
   * \param motion the displacement of all points, metres \param frame the current one
   */
  void
  writeResult (const cv::Scalar& motion = {0.02, 0, 0}, int frame = 1) const
  {
    SceneFlow flow;
    flow.camera = scene_.camera;
    const cv::Size size (SmallScene::kWidth, SmallScene::kHeight);
    const cv::Mat depth = SmallScene::depth (0);
    flow.points.create (size, CV_32FC3);
    flow.displacement = cv::Mat (size, CV_32FC3, motion);
    flow.labels = cv::Mat (size, CV_32SC1, cv::Scalar (0));
    flow.visibility =
        cv::Mat (size, CV_8UC1, cv::Scalar (pixelValue (Visibility::Visible)));
    for (int row = 0; row < size.height; ++row)
      for (int col = 0; col < size.width; ++col) {
        const Eigen::Vector3f p =
            scene_.camera.backProject (col, row, depth.at<float> (row, col))
                .cast<float>();
        flow.points.at<cv::Vec3f> (row, col) = {p.x(), p.y(), p.z()};
      }
    std::filesystem::create_directory (folder_ ("result"));
    io::writeSceneFlowCloud (
        folder_ ("result/scene_flow_0_" + std::to_string (frame) + ".pcd"),
        flow,
        SmallScene::color (0));
  }

  const std::string tool_{PCL_MSF_TOOLS "/pcl_msf_render"};
  TemporaryFolder folder_;
  SmallScene scene_;
};

} // namespace pcl_msf::testing
