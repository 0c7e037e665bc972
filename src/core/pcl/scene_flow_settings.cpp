// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/console/print.h>

#include <pcl_msf/scene_flow_settings.h>

#include <cmath>

namespace pcl_msf {

void
SceneFlowSettings::printError (const char* method, const std::string& why) const
{
  PCL_ERROR ("[pcl_msf::%s::%s] %s\n", owner_, method, why.c_str());
}

void
SceneFlowSettings::setCamera (const PinholeCamera& camera)
{
  const auto finite = std::isfinite (camera.fx) && std::isfinite (camera.fy) &&
                      std::isfinite (camera.cx) && std::isfinite (camera.cy);
  if (finite && camera.fx > 0.0 && camera.fy > 0.0)
    camera_ = camera;
  else
    printError (
        "setCamera",
        "focal lengths must be positive and all four numbers finite, in pixels; "
        "clearCamera returns to estimating the camera");
}

void
SceneFlowSettings::setFrameParameters (const FrameParameters& parameters)
{
  std::string why;
  if (parameters.isValid (&why))
    frame_ = parameters;
  else
    printError ("setFrameParameters", why);
}

void
SceneFlowSettings::setSegmentationParameters (const SegmentationParameters& parameters)
{
  std::string why;
  if (parameters.isValid (&why))
    segmentation_ = parameters;
  else
    printError ("setSegmentationParameters", why);
}

void
SceneFlowSettings::setEnergyParameters (const EnergyParameters& parameters)
{
  std::string why;
  if (parameters.isValid (&why))
    energy_ = parameters;
  else
    printError ("setEnergyParameters", why);
}

void
SceneFlowSettings::setSegmentationMethod (SegmentationMethod method)
{
  if (method >= SegmentationMethod::TangentPlane &&
      method <= SegmentationMethod::Single)
    segmentation_.method = method;
  else
    printError ("setSegmentationMethod", "not a value of SegmentationMethod");
}

void
SceneFlowSettings::setMultiframeParameters (const MultiframeParameters& parameters)
{
  std::string why;
  if (parameters.isValid (&why))
    multiframe_ = parameters;
  else
    printError ("setMultiframeParameters", why);
}

void
SceneFlowSettings::setNumberOfThreads (unsigned threads)
{
  SolverParameters parameters = solver_;
  parameters.threads = threads;
  takeSolverParameters (parameters, "setNumberOfThreads");
}

bool
SceneFlowSettings::takeSolverParameters (const SolverParameters& parameters,
                                         const char* method)
{
  std::string why;
  const bool valid = parameters.isValid (&why);
  if (valid)
    solver_ = parameters;
  else
    printError (method, why);
  return valid;
}

} // namespace pcl_msf
