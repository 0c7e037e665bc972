// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/PointIndices.h>

#include <pcl_msf/cloud_constraints.h>
#include <pcl_msf/export.h>
#include <pcl_msf/scene_flow_settings.h>

#include <vector>

namespace pcl_msf {

/** \brief How a point of the source finds the target's. */
enum class CorrespondenceMethod {
  Auto,           ///< NearestNeighbor where the source or every target has no grid: one
                  ///< row or column, or points that are not width x height
  Projective,     ///< by the camera: brightness and projective ICP
  NearestNeighbor ///< by place and normal, see CloudFlowEstimator
};

/** \brief What a user sets on a PiecewiseRigidRegistration, whatever its point type:
 * SceneFlowSettings, and normals and segments of the source from outside. The same
 * rules hold; sizes are judged in align. */
class PCL_MSF_EXPORT RegistrationSettings : public SceneFlowSettings {
public:
  using NormalCloudConstPtr = pcl::PointCloud<pcl::Normal>::ConstPtr;
  using LabelCloudConstPtr = pcl::PointCloud<pcl::Label>::ConstPtr;

  /** \brief Normals of the source, one per point, used in place of computed ones. By
   * the camera they are organized like the source, of unit length, NaN = none; by
   * nearest neighbours of any length and to either side (which side is out, is found
   * along the surface), NaN or zero = computed. A null pointer returns to computed
   * ones, an empty cloud is refused. */
  void
  setSourceNormals (const NormalCloudConstPtr& normals);
  NormalCloudConstPtr
  getSourceNormals () const
  {
    return normals_;
  }

  /** \brief Segments from outside: one label per point of the source, by the camera
   * organized like it. See labelImage for "none"; points that PCL's
   * SupervoxelClustering leaves out bear 0, a label like any other: make it the largest
   * number. Replaces clusters; a null pointer and an empty cloud are refused.
   *
   * Points in no segment take no part, their motion is unknown. By nearest neighbours,
   * too, segments are used as they are: each is rigid, see CloudFlowEstimator;
   * SceneFlow's segments are these, in ascending order of labels, its groups the parts
   * that they were joined to. */
  void
  setSegmentation (const LabelCloudConstPtr& labels);
  LabelCloudConstPtr
  getSegmentationLabels () const
  {
    return labels_;
  }

  /** \brief Segments from outside: clusters of source indices, as PCL's segmentations
   * give them. Replaces labels; an empty list is refused. */
  void
  setSegmentation (const std::vector<pcl::PointIndices>& clusters);
  std::vector<pcl::PointIndices>
  getSegmentationIndices () const
  {
    return clusters_;
  }

  /** \brief How points find each other, default Auto: clouds without a grid by nearest
   * neighbours. With NearestNeighbor camera, frame and segmentation parameters have
   * no effect, of the energy's only brightness_weight: of colours beside shapes
   * where both clouds have some that vary, 0 = shapes alone, and of the multiframe's
   * only concatenation_weight, of neighbouring frames; of the solver's only
   * max_seconds, threads, merge_bodies and progress, see CloudFlowEstimator. */
  void
  setCorrespondence (CorrespondenceMethod method);
  CorrespondenceMethod
  getCorrespondence () const
  {
    return correspondence_;
  }

  /** \brief What is known beforehand of clouds that are registered by nearest
   * neighbours: pairs, weights, fixed segments and segments' guesses. Refused when not
   * valid; whether indices and labels exist is judged in align, which fails when the
   * clouds are registered by the camera. Default: nothing, and {} returns to it. */
  void
  setCloudConstraints (const CloudConstraints& constraints);
  CloudConstraints
  getCloudConstraints () const
  {
    return constraints_;
  }

  /** \brief Back to segments by SegmentationParameters. */
  void
  clearSegmentation ();

protected:
  RegistrationSettings() : SceneFlowSettings ("PiecewiseRigidRegistration") {}
  ~RegistrationSettings() = default;

  NormalCloudConstPtr normals_;
  CorrespondenceMethod correspondence_{CorrespondenceMethod::Auto};
  CloudConstraints constraints_;
  LabelCloudConstPtr labels_;
  std::vector<pcl::PointIndices> clusters_;
};

} // namespace pcl_msf
