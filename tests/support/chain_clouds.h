// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/common/point_tests.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "support/box_chain.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_msf::testing {

/** \brief Points as a cloud without a grid. */
template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr
cloudOf (const std::vector<Eigen::Vector3f>& points)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<PointT>>();
  for (const auto& p : points) {
    PointT point;
    point.getVector3fMap() = p;
    cloud->push_back (point);
  }
  return cloud;
}

/** \brief The box that a point of a chain at rest lies on. */
template <typename PointT>
int
boxOf (const BoxChain& chain, const PointT& point)
{
  return std::clamp (static_cast<int> (point.x / chain.size.x()), 0, chain.boxes - 1);
}

/** \brief Mean distance of the known points from where the chain's motion takes points
 * of the source, which is at rest. */
template <typename PointT>
double
meanChainError (const BoxChain& chain,
                const pcl::PointCloud<PointT>& source,
                const pcl::PointCloud<PointT>& warped)
{
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < source.size() && source.size() == warped.size(); ++i) {
    if (!pcl::isXYZFinite (source[i]) || !pcl::isXYZFinite (warped[i]))
      continue;
    const Eigen::Vector3d truth = chain.pose (boxOf (chain, source[i])) *
                                  source[i].getVector3fMap().template cast<double>();
    sum += (truth - warped[i].getVector3fMap().template cast<double>()).norm();
    ++count;
  }
  return count > 0 ? sum / count : std::numeric_limits<double>::infinity();
}

} // namespace pcl_msf::testing
