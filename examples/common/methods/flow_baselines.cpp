// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>
#ifdef PCL_MSF_HAS_OPTFLOW
#include <opencv2/optflow.hpp>
#endif

#include "common/methods/baselines.h"
#include "common/methods/lifting.h"
#include "common/stop_watch.h"
#include "core/base/lazy_library.h"

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

/** Below so many pixels a side, two patches, OpenCV's DIS reads outside the image. */
constexpr int kLeastSide = 16;

/** The border is repeated where an image is too small. */
cv::Mat
largeEnough (const cv::Mat& image)
{
  cv::Mat result;
  cv::copyMakeBorder (image,
                      result,
                      0,
                      std::max (0, kLeastSide - image.rows),
                      0,
                      std::max (0, kLeastSide - image.cols),
                      cv::BORDER_REPLICATE);
  return result;
}

Estimate
runFlow (cv::DenseOpticalFlow& algorithm, const PairData& pair)
{
  StopWatch watch;
  const cv::Mat first = gray (pair.reference.color);
  cv::Mat flow;
  algorithm.calc (largeEnough (first), largeEnough (gray (pair.current.color)), flow);
  Estimate estimate;
  estimate.flow = flow (cv::Rect (cv::Point(), first.size())).clone();
  estimate.seconds.solve = watch.lap();
  liftByDepth (pair, estimate);
  estimate.seconds.total = estimate.seconds.solve + watch.lap();
  return estimate;
}

} // namespace

Estimate
DisFlow::run (const PairData& pair) const
{
  return runFlow (*cv::DISOpticalFlow::create (preset_), pair);
}

#ifdef PCL_MSF_HAS_OPTFLOW
namespace {

cv::Ptr<cv::optflow::DualTVL1OpticalFlow>
dualTvL1 ()
{
#ifdef PCL_MSF_OPTFLOW_FILES
  using Create = cv::Ptr<cv::optflow::DualTVL1OpticalFlow>();
  static auto* const create = loadFunction<Create> (
      {PCL_MSF_OPTFLOW_FILES}, "_ZN2cv7optflow22createOptFlow_DualTVL1Ev");
  return create();
#else
  return cv::optflow::createOptFlow_DualTVL1();
#endif
}

} // namespace

Estimate
TvL1Flow::run (const PairData& pair) const
{
  const auto algorithm = dualTvL1();
  algorithm->setScaleStep (0.5);
  algorithm->setScalesNumber (6);
  algorithm->setEpsilon (0.02);
  return runFlow (*algorithm, pair);
}
#endif

} // namespace pcl_msf::tool
