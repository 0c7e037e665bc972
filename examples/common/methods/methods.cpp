// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/video/tracking.hpp>

#include "common/methods/baselines.h"
#include "common/methods/own_method.h"

#include <limits>

namespace pcl_msf::tool {

namespace {

constexpr const char* kIndependent =
    "neighbors=0:regularizer-weight=0:merge-bodies=0:blend-motions=0";

} // namespace

StageSeconds::StageSeconds()
: total (std::numeric_limits<double>::quiet_NaN())
, frame (total)
, segment (total)
, start (total)
, solve (total)
, result (total)
{}

bool
Method::canRun (const PairData&) const
{
  return true;
}

std::vector<std::pair<std::string, std::string>>
methodHelp ()
{
  return {{"msf", "our method with its defaults"},
          {"msf:KEY=VALUE[:...]",
           "with settings: options of pcl_msf_scene_flow without the dashes, "
           "labels=true|cut, start=true"},
          {"zero", "no motion"},
          {"rigid", "one rigid motion: our method with a single segment"},
          {"gicp", "one rigid motion by pcl::GeneralizedIterativeClosestPoint"},
          {"independent", "our method with nothing between segments"},
          {"dis_fast", "OpenCV's DIS optical flow, fast preset, lifted by depth"},
          {"dis_medium", "the same, medium preset"},
#ifdef PCL_MSF_HAS_OPTFLOW
          {"tvl1", "OpenCV's TV-L1 optical flow (6 octaves), lifted by depth"}
#endif
  };
}

std::unique_ptr<Method>
makeMethod (const std::string& spec, unsigned threads)
{
  if (spec == "msf")
    return std::make_unique<OwnMethod> ("", threads);
  if (spec.rfind ("msf:", 0) == 0)
    return std::make_unique<OwnMethod> (spec.substr (4), threads);
  if (spec == "zero")
    return std::make_unique<ZeroFlow>();
  if (spec == "rigid")
    return std::make_unique<OwnMethod> ("segmentation=single", threads);
  if (spec == "gicp")
    return std::make_unique<Gicp>();
  if (spec == "independent")
    return std::make_unique<OwnMethod> (kIndependent, threads);
  if (spec == "dis_fast")
    return std::make_unique<DisFlow> (cv::DISOpticalFlow::PRESET_FAST);
  if (spec == "dis_medium")
    return std::make_unique<DisFlow> (cv::DISOpticalFlow::PRESET_MEDIUM);
#ifdef PCL_MSF_HAS_OPTFLOW
  if (spec == "tvl1")
    return std::make_unique<TvL1Flow>();
#endif
  std::string names;
  for (const auto& [name, help] : methodHelp())
    names += (names.empty() ? "" : ", ") + name;
  throw UsageError ("--methods: no method '" + spec + "'; there are " + names);
}

} // namespace pcl_msf::tool
