// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <opencv2/core.hpp>

#include <pcl_msf/pinhole_camera.h>
#include <synthetic/soft_surface.h>

#include <array>
#include <vector>

namespace pcl_msf::synthetic {

/** \brief Triangles on a soft surface, sorted into squares of the image: where Newton's
 * method starts for a ray. Thread-safe once made. */
class StartMesh {
public:
  /** \param rotation, translation body to camera coordinates */
  StartMesh (const SoftForm& form,
             const Eigen::Vector2d& half,
             const Eigen::Matrix3d& rotation,
             const Eigen::Vector3d& translation,
             const PinholeCamera& camera);

  /** \brief The starts (u, v, depth) of the triangles that a ray meets, or nearly so.
   * \param[out] starts nearest first; its content is replaced */
  void
  startsFor (const Eigen::Vector3d& direction,
             std::vector<Eigen::Vector3d>& starts) const;

  /** \brief Pixels that the surface may cover. */
  const cv::Rect2d&
  bounds () const
  {
    return bounds_;
  }

  /** \brief Size of a mesh cell, metres of material coordinates. */
  double
  cellSize () const
  {
    return cell_size_;
  }

private:
  struct Vertex {
    Eigen::Vector2d uv;
    Eigen::Vector3d point; ///< camera coordinates
  };
  using Triangle = std::array<int, 3>;

  void
  makeTriangles ();

  void
  fillBins ();

  cv::Rect2d
  boundsOf (const Triangle& triangle) const;

  bool
  startIn (const Triangle& triangle,
           const Eigen::Vector3d& direction,
           Eigen::Vector3d& start) const;

  PinholeCamera camera_;
  double cell_size_;
  std::vector<Vertex> vertices_;
  std::vector<Triangle> triangles_;
  cv::Rect2d bounds_;
  int columns_{0}, rows_{0};
  std::vector<std::vector<int>> bins_; ///< triangles that may cover an image square
};

} // namespace pcl_msf::synthetic
