// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "cloud_methods.h"

#include <pcl/registration/gicp.h>
#include <pcl/registration/icp.h>

#include "common/interruption.h"
#include "common/stop_watch.h"
#include <pcl_msf/cloud_flow_estimator.h>

namespace pcl_msf::tool {

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr std::size_t kMostPoints = 12000; // of each cloud, for PCL's
constexpr int kIterations = 50;

/** Every so manieth finite point. */
Cloud::Ptr
sparse (const std::vector<Eigen::Vector3f>& points)
{
  const std::size_t step = (points.size() + kMostPoints - 1) / kMostPoints;
  auto cloud = pcl::make_shared<Cloud>();
  for (std::size_t i = 0; i < points.size(); i += step)
    if (points[i].allFinite())
      cloud->emplace_back (points[i].x(), points[i].y(), points[i].z());
  return cloud;
}

CloudEstimate
runPcl (pcl::Registration<pcl::PointXYZ, pcl::PointXYZ>& registration,
        const CloudCase& data)
{
  registration.setInputSource (sparse (data.source));
  registration.setInputTarget (sparse (data.target));
  registration.setMaximumIterations (kIterations);
  Cloud aligned;
  registration.align (aligned);
  CloudEstimate estimate;
  estimate.converged = registration.hasConverged();
  const Eigen::Matrix4f m = registration.getFinalTransformation();
  for (const Eigen::Vector3f& p : data.source)
    estimate.warped.push_back (m.topLeftCorner<3, 3>() * p + m.topRightCorner<3, 1>());
  return estimate;
}

CloudEstimate
runOwn (const CloudCase& data, unsigned threads)
{
  SolverParameters solver;
  solver.threads = threads;
  solver.progress = [] (const Progress&) {
    throwIfInterrupted();
    return true;
  };
  CloudFlow flow = CloudFlowEstimator (solver).estimate (data.source, data.target);
  return {std::move (flow.warped), flow.report.converged, 0.0};
}

} // namespace

std::vector<std::pair<std::string, std::string>>
cloudMethodHelp ()
{
  return {{"zero", "no motion"},
          {"icp", "one rigid motion, pcl::IterativeClosestPoint"},
          {"gicp", "one rigid motion, pcl::GeneralizedIterativeClosestPoint"},
          {"msf", "ours, CloudFlowEstimator"}};
}

CloudEstimate
runCloudMethod (const std::string& method, const CloudCase& data, unsigned threads)
{
  StopWatch watch;
  CloudEstimate estimate;
  if (method == "icp") {
    pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> icp;
    estimate = runPcl (icp, data);
  }
  else if (method == "gicp") {
    pcl::GeneralizedIterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> gicp;
    estimate = runPcl (gicp, data);
  }
  else if (method == "msf")
    estimate = runOwn (data, threads);
  else
    estimate = {data.source, true, 0.0};
  estimate.seconds = watch.lap();
  return estimate;
}

} // namespace pcl_msf::tool
