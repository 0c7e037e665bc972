// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/console/print.h>

#include <pcl_msf/registration_settings.h>

#include <cmath>

namespace pcl_msf {

void
RegistrationSettings::printError (const char* method, const std::string& why)
{
  PCL_ERROR ("[pcl_msf::PiecewiseRigidRegistration::%s] %s\n", method, why.c_str());
}

void
RegistrationSettings::setCamera (const PinholeCamera& camera)
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
RegistrationSettings::setFrameParameters (const FrameParameters& parameters)
{
  std::string why;
  if (parameters.isValid (&why))
    frame_ = parameters;
  else
    printError ("setFrameParameters", why);
}

void
RegistrationSettings::setSegmentationParameters (
    const SegmentationParameters& parameters)
{
  std::string why;
  if (parameters.isValid (&why))
    segmentation_ = parameters;
  else
    printError ("setSegmentationParameters", why);
}

void
RegistrationSettings::setEnergyParameters (const EnergyParameters& parameters)
{
  std::string why;
  if (parameters.isValid (&why))
    energy_ = parameters;
  else
    printError ("setEnergyParameters", why);
}

void
RegistrationSettings::setSegmentationMethod (SegmentationMethod method)
{
  if (method >= SegmentationMethod::TangentPlane &&
      method <= SegmentationMethod::Single)
    segmentation_.method = method;
  else
    printError ("setSegmentationMethod", "not a value of SegmentationMethod");
}

void
RegistrationSettings::setMultiframeParameters (const MultiframeParameters& parameters)
{
  std::string why;
  if (parameters.isValid (&why))
    multiframe_ = parameters;
  else
    printError ("setMultiframeParameters", why);
}

void
RegistrationSettings::setSegmentSize (int pixels)
{
  SegmentationParameters parameters = segmentation_;
  parameters.segment_size = pixels;
  std::string why;
  if (parameters.isValid (&why))
    segmentation_ = parameters;
  else
    printError ("setSegmentSize", why);
}

void
RegistrationSettings::setRegularizerWeight (double gamma)
{
  EnergyParameters parameters = energy_;
  parameters.regularizer_weight = gamma;
  std::string why;
  if (parameters.isValid (&why))
    energy_ = parameters;
  else
    printError ("setRegularizerWeight", why);
}

void
RegistrationSettings::setNumberOfThreads (unsigned threads)
{
  constexpr unsigned most = 1024; // more is a negative number in disguise
  if (threads <= most)
    solver_.threads = threads;
  else
    printError ("setNumberOfThreads", "threads must be in [0, 1024]; 0 = all");
}

void
RegistrationSettings::setTimeBudget (double seconds)
{
  SolverParameters parameters = solver_;
  parameters.max_seconds = seconds;
  takeSolverParameters (parameters, "setTimeBudget");
}

bool
RegistrationSettings::takeSolverParameters (const SolverParameters& parameters,
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

void
RegistrationSettings::setSourceNormals (const NormalCloudConstPtr& normals)
{
  if (!normals || normals->height > 1)
    normals_ = normals;
  else
    printError ("setSourceNormals",
                "the normals are not organized: compute them on the whole source, or "
                "give a null pointer to have them computed");
}

void
RegistrationSettings::setSegmentation (const LabelCloudConstPtr& labels)
{
  if (labels && labels->height > 1) {
    labels_ = labels;
    clusters_.clear();
  }
  else
    printError ("setSegmentation",
                "the labels are not organized: give one per point of the source; "
                "clearSegmentation returns to segments by parameters");
}

void
RegistrationSettings::setSegmentation (const std::vector<pcl::PointIndices>& clusters)
{
  for (const auto& cluster : clusters)
    if (!cluster.indices.empty()) {
      clusters_ = clusters;
      labels_.reset();
      return;
    }
  printError ("setSegmentation",
              "no cluster has a point; clearSegmentation returns to segments by "
              "parameters");
}

void
RegistrationSettings::clearSegmentation()
{
  labels_.reset();
  clusters_.clear();
}

} // namespace pcl_msf
