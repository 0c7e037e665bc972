// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/PointIndices.h>

#include <pcl_msf/scene_flow.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace pcl_msf {

/** \brief Motion group of a point of the reference; -1 = none. \param index row * width
 * + column */
inline int
motionGroupOf (const SceneFlow& flow, std::size_t index)
{
  const auto width = static_cast<std::size_t> (flow.labels.cols);
  const int label = flow.labels.at<int> (static_cast<int> (index / width),
                                         static_cast<int> (index % width));
  return label < 0 ? -1 : flow.segments[label].group;
}

/** \brief What moves together as PCL's segmentations tell it: element g holds the
 * points of motion group g, ascending. Points in no group are in none of them. */
inline std::vector<pcl::PointIndices>
motionClusters (const SceneFlow& flow)
{
  std::vector<pcl::PointIndices> clusters (flow.groups);
  for (std::size_t i = 0; i < flow.labels.total(); ++i)
    if (const int group = motionGroupOf (flow, i); group >= 0)
      clusters[group].indices.push_back (static_cast<pcl::index_t> (i));
  return clusters;
}

/** \brief The same as a label per point, organized like the reference; the largest
 * number = none, as setSegmentation takes it. */
inline pcl::PointCloud<pcl::Label>
motionLabels (const SceneFlow& flow)
{
  pcl::PointCloud<pcl::Label> labels (flow.labels.cols, flow.labels.rows);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const int group = motionGroupOf (flow, i);
    labels[i].label = group < 0 ? std::numeric_limits<std::uint32_t>::max()
                                : static_cast<std::uint32_t> (group);
  }
  return labels;
}

} // namespace pcl_msf
