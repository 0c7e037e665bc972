// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <Eigen/Geometry>

#include <vtkCellArray.h>

#include "visualization/base/vtk_actors.h"
#include "visualization/base/vtk_vertices.h"

#include <algorithm>
#include <array>

namespace pcl_msf::visualization {

namespace {

constexpr int kSides = 10;
constexpr double kPi = 3.14159265358979323846;
// Shares of the length, or of the thickest length when that is less.
constexpr float kShaftRadius = 0.06F;
constexpr float kHeadRadius = 0.19F;
constexpr float kHeadLength = 0.42F;

using Ring = std::array<vtkIdType, kSides>;

/** Builds arrows out of polygons. */
class ArrowMesh {
public:
  void
  add (const Arrow& arrow)
  {
    const Eigen::Vector3f foot (arrow.from[0], arrow.from[1], arrow.from[2]);
    const Eigen::Vector3f tip (arrow.to[0], arrow.to[1], arrow.to[2]);
    const float length = (tip - foot).norm();
    if (!(length > 0.0F))
      return;
    direction_ = (tip - foot) / length;
    side_ = direction_.unitOrthogonal();
    color_ = arrow.color;
    const float size = std::min (length, arrow.thickest);
    const Eigen::Vector3f neck = tip - kHeadLength * size * direction_;
    const Ring bottom = ring (foot, kShaftRadius * size);
    const Ring top = ring (neck, kShaftRadius * size);
    const Ring brim = ring (neck, kHeadRadius * size);
    const vtkIdType point = vertex (tip);
    polygon (bottom.data(), kSides);
    polygon (brim.data(), kSides);
    for (int i = 0; i < kSides; ++i) {
      const int next = (i + 1) % kSides;
      const vtkIdType wall[] = {bottom[i], bottom[next], top[next], top[i]};
      const vtkIdType slope[] = {brim[i], brim[next], point};
      polygon (wall, 4);
      polygon (slope, 3);
    }
  }

  vtkSmartPointer<vtkPolyData>
  polyData () const
  {
    auto data = vertices_.polyData();
    data->SetPolys (cells_);
    return data;
  }
  bool
  empty () const
  {
    return vertices_.size() == 0;
  }

private:
  vtkIdType
  vertex (const Eigen::Vector3f& at)
  {
    return vertices_.add ({at.x(), at.y(), at.z()}, color_);
  }
  Ring
  ring (const Eigen::Vector3f& center, float radius)
  {
    Ring result{};
    const Eigen::Vector3f other = direction_.cross (side_);
    for (int i = 0; i < kSides; ++i) {
      const auto turn = static_cast<float> (2.0 * kPi * i / kSides);
      result[i] = vertex (center +
                          radius * (std::cos (turn) * side_ + std::sin (turn) * other));
    }
    return result;
  }
  void
  polygon (const vtkIdType* corners, int count)
  {
    cells_->InsertNextCell (count, corners);
  }

  Vertices vertices_;
  vtkSmartPointer<vtkCellArray> cells_ = vtkSmartPointer<vtkCellArray>::New();
  Eigen::Vector3f direction_;
  Eigen::Vector3f side_;
  cv::Vec3b color_;
};

} // namespace

vtkSmartPointer<vtkActor>
arrowActor (const std::vector<Arrow>& arrows)
{
  ArrowMesh mesh;
  for (const Arrow& arrow : arrows)
    if (isFinite (arrow.from) && isFinite (arrow.to))
      mesh.add (arrow);
  if (mesh.empty())
    return nullptr;
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData (mesh.polyData());
  auto actor = actorOf (mapper, true);
  actor->GetProperty()->SetAmbient (0.5);
  actor->GetProperty()->SetDiffuse (0.5);
  return actor;
}

} // namespace pcl_msf::visualization
