// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <synthetic/part_view.h>
#include <synthetic/start_mesh.h>

#include <cmath>

namespace pcl_msf::synthetic {
namespace {

constexpr double step = 1e-6;      ///< of differences, metres: tangents to about 1e-6
constexpr double accuracy = 1e-11; ///< of hits, metres

/** A place on the surface and its tangents. */
struct Tangents {
  Eigen::Vector3d point, du, dv;

  Eigen::Vector3d
  normal () const
  {
    return du.cross (dv).normalized();
  }
};

Tangents
tangentsOf (const SoftForm& form, double u, double v)
{
  const Eigen::Vector3d point = form.place (u, v);
  return {point,
          (form.place (u + step, v) - point) / step,
          (form.place (u, v + step) - point) / step};
}

class SoftView : public PartView {
public:
  SoftView (const SoftSurface& surface,
            const Isometry& camera_from_part,
            const PinholeCamera& camera,
            double phase)
  : half_ (surface.halfSize())
  , form_ (surface.formAt (phase))
  , rest_form_ (surface.formAt (0.0))
  , rotation_ (camera_from_part.linear())
  , translation_ (camera_from_part.translation())
  , mesh_ (*form_, half_, rotation_, translation_, camera)
  {}

  bool
  cast (const Eigen::Vector3d& direction, double limit, ViewHit& hit) const override;

  Eigen::Matrix3d
  materialFromCamera (const ViewHit& hit) const override
  {
    const Tangents t = tangents (hit.material.x(), hit.material.y());
    Eigen::Matrix3d camera_from_material;
    camera_from_material << t.du, t.dv, t.normal();
    Eigen::Matrix3d inverse = camera_from_material.inverse();
    inverse.row (2).setZero();
    return inverse;
  }

  Eigen::Vector3d
  place (const Eigen::Vector3d& material) const override
  {
    return rotation_ * form_->place (material.x(), material.y()) + translation_;
  }

  Eigen::Vector3d
  restNormal (const ViewHit& hit) const override
  {
    const Eigen::Vector3d normal =
        tangentsOf (*rest_form_, hit.material.x(), hit.material.y()).normal();
    return hit.back ? -normal : normal;
  }

  cv::Rect2d
  bounds () const override
  {
    return mesh_.bounds();
  }

private:
  bool
  refine (const Eigen::Vector3d& direction, Eigen::Vector3d& uvs) const;

  bool
  isOnSurface (const Eigen::Vector3d& uvs) const
  {
    return std::abs (uvs.x()) <= half_.x() && std::abs (uvs.y()) <= half_.y();
  }

  /** In camera coordinates. */
  Tangents
  tangents (double u, double v) const
  {
    const Tangents t = tangentsOf (*form_, u, v);
    return {rotation_ * t.point + translation_, rotation_ * t.du, rotation_ * t.dv};
  }

  Eigen::Vector2d half_;
  std::unique_ptr<SoftForm> form_, rest_form_;
  Eigen::Matrix3d rotation_;
  Eigen::Vector3d translation_;
  StartMesh mesh_;
};

/** Newton's method for place (u, v) = s direction; the derivatives stay when the rest
 * is small. */
bool
SoftView::refine (const Eigen::Vector3d& direction, Eigen::Vector3d& uvs) const
{
  const Eigen::Vector2d start = uvs.head<2>();
  Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();
  double last = 1e9;
  for (int i = 0; i < 10; ++i) {
    const Eigen::Vector3d point = place (uvs);
    const double error = (point - uvs.z() * direction).norm();
    if (error < accuracy)
      return true;
    if (i == 0 || error > 1e-6 || error > 0.1 * last) {
      const Tangents t = tangents (uvs.x(), uvs.y());
      Eigen::Matrix3d jacobian;
      jacobian << t.du, t.dv, -direction;
      if (std::abs (jacobian.determinant()) < 1e-9)
        return false;
      inverse = jacobian.inverse();
    }
    uvs -= inverse * (point - uvs.z() * direction);
    if (!((uvs.head<2>() - start).norm() < 1.5 * mesh_.cellSize()))
      return false;
    last = error;
  }
  return false;
}

bool
SoftView::cast (const Eigen::Vector3d& direction, double limit, ViewHit& hit) const
{
  thread_local std::vector<Eigen::Vector3d> starts, tried;
  mesh_.startsFor (direction, starts);
  tried.clear();
  bool found = false;
  for (Eigen::Vector3d uvs : starts) {
    if (uvs.z() > 1.05 * limit)
      break;
    // Neighbouring triangles lead to the same place.
    bool same = false;
    for (const Eigen::Vector3d& other : tried)
      same = same || (uvs - other).norm() < 0.25 * mesh_.cellSize();
    if (same || !refine (direction, uvs))
      continue;
    tried.push_back (uvs);
    if (!(uvs.z() > 0.0 && uvs.z() < limit) || !isOnSurface (uvs))
      continue;
    limit = uvs.z();
    hit.depth = limit;
    hit.material = {uvs.x(), uvs.y(), 0.0};
    found = true;
  }
  if (!found)
    return false;
  hit.normal = tangents (hit.material.x(), hit.material.y()).normal();
  hit.back = hit.normal.dot (direction) > 0.0;
  if (hit.back)
    hit.normal = -hit.normal;
  return true;
}

} // namespace

std::unique_ptr<PartView>
makeSoftView (const SoftSurface& surface,
              const Isometry& camera_from_part,
              const PinholeCamera& camera,
              double phase)
{
  return std::make_unique<SoftView> (surface, camera_from_part, camera, phase);
}

} // namespace pcl_msf::synthetic
