// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Colour and depth images in, scene flow out; no clouds.
#include "example_clouds.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/oversegmentation.h>
#include <pcl_msf/rgbd_frame.h>
#include <pcl_msf/scene_flow_estimator.h>

#include <iostream>

int
main ()
{
  using namespace pcl_msf;
  const auto& sequence = exampleSequence();
  const auto& first = sequence.frames[0]; // color: CV_8UC3, depth: CV_32FC1, metres
  const auto& second = sequence.frames[1];
  try {
    const RgbdFrame reference =
        RgbdFrame::fromImages (first.color, first.depth, sequence.camera);
    const RgbdFrame current =
        RgbdFrame::fromImages (second.color, second.depth, sequence.camera);
    const Oversegmentation segments = Oversegmentation::fromFrame (reference);

    const SceneFlow result =
        SceneFlowEstimator().estimate (reference, current, segments);

    const cv::Vec2f flow = result.flow.at<cv::Vec2f> (60, 80);
    const cv::Vec3f displacement = result.displacement.at<cv::Vec3f> (60, 80);
    std::cout << "the middle point moves by " << flow << " pixels, " << displacement
              << " m; " << result.groups << " motion groups\n";
    return result.report.converged ? 0 : 1;
  }
  catch (const InvalidInput& error) { // images that do not fit, and the remedy
    std::cerr << error.what() << "\n";
    return 1;
  }
}
