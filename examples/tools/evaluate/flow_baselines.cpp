// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>
#ifdef PCL_MSF_HAS_OPTFLOW
#include <opencv2/optflow.hpp>
#endif

#include "baselines.h"
#include "common/stop_watch.h"
#include "lifting.h"

namespace pcl_msf::tool {

namespace {

cv::Mat
gray (const cv::Mat& color)
{
  cv::Mat result = color;
  if (color.channels() == 3)
    cv::cvtColor (color, result, cv::COLOR_BGR2GRAY);
  return result;
}

Estimate
runFlow (cv::DenseOpticalFlow& algorithm, const PairData& pair)
{
  StopWatch watch;
  Estimate estimate;
  algorithm.calc (
      gray (pair.reference.color), gray (pair.current.color), estimate.flow);
  liftByDepth (pair, estimate);
  estimate.seconds.total = watch.lap();
  return estimate;
}

} // namespace

Estimate
DisFlow::run (const PairData& pair) const
{
  return runFlow (*cv::DISOpticalFlow::create (preset_), pair);
}

#ifdef PCL_MSF_HAS_OPTFLOW
Estimate
TvL1Flow::run (const PairData& pair) const
{
  const auto algorithm = cv::optflow::DualTVL1OpticalFlow::create();
  algorithm->setScaleStep (0.5);
  algorithm->setScalesNumber (6);
  algorithm->setEpsilon (0.02);
  return runFlow (*algorithm, pair);
}
#endif

} // namespace pcl_msf::tool
