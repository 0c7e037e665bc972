// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "visualization/base/vtk_actors.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include "visualization/base/vtk_vertices.h"
#include <pcl_msf/errors.h>

#include <algorithm>
#include <array>
#include <vector>

namespace pcl_msf::visualization {

namespace {

constexpr double kOffset = 4000.0; ///< of depth, in 2^-16 of its range
constexpr double kLineOffset = 200.0;

/** \param vertex of each point, -1 = not drawn */
vtkSmartPointer<vtkCellArray>
trianglesOf (const PointSet& set, const std::vector<vtkIdType>& vertex)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  const auto count = static_cast<int> (vertex.size());
  for (const cv::Vec3i& triangle : set.triangles) {
    std::array<vtkIdType, 3> corners{};
    for (int i = 0; i < 3; ++i) {
      if (triangle[i] < 0 || triangle[i] >= count)
        throw InvalidInput ("points: a triangle's corner is no point");
      corners[i] = vertex[triangle[i]];
    }
    if (*std::min_element (corners.begin(), corners.end()) >= 0)
      cells->InsertNextCell (3, corners.data());
  }
  return cells;
}

} // namespace

vtkSmartPointer<vtkActor>
pointActor (const PointSet& set, double pixels, bool behind)
{
  if (set.positions.type() != CV_32FC3 || set.colors.type() != CV_8UC3 ||
      set.positions.size() != set.colors.size())
    throw InvalidInput ("points: positions must be CV_32FC3 and colours CV_8UC3 of the "
                        "same size");
  Vertices vertices;
  std::vector<vtkIdType> vertex (set.positions.total(), -1);
  for (int row = 0; row < set.positions.rows; ++row)
    for (int col = 0; col < set.positions.cols; ++col) {
      const auto& p = set.positions.at<cv::Vec3f> (row, col);
      if (isFinite (p))
        vertex[row * set.positions.cols + col] =
            vertices.add (p, set.colors.at<cv::Vec3b> (row, col));
    }
  if (vertices.size() == 0)
    return nullptr;
  const auto data = vertices.polyData();
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->InsertNextCell (static_cast<int> (vertices.size()));
  for (vtkIdType i = 0; i < vertices.size(); ++i)
    cells->InsertCellPoint (i);
  data->SetVerts (cells);
  data->SetPolys (trianglesOf (set, vertex));
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData (data);
  if (behind) { // what lies on the cloud is drawn over it
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyPointOffsetParameter (kOffset);
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters (0.0, kOffset);
  }
  auto actor = actorOf (mapper, false);
  actor->GetProperty()->SetPointSize (static_cast<float> (pixels));
  return actor;
}

vtkSmartPointer<vtkActor>
lineActor (const std::vector<Polyline>& lines, double pixels, bool behind)
{
  Vertices vertices;
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const Polyline& line : lines) {
    if (line.points.size() != line.colors.size())
      throw InvalidInput ("lines: as many colours as points are needed");
    std::vector<vtkIdType> chain;
    for (std::size_t i = 0; i < line.points.size(); ++i)
      if (isFinite (line.points[i]))
        chain.push_back (vertices.add (line.points[i], line.colors[i]));
    if (chain.size() > 1)
      cells->InsertNextCell (static_cast<vtkIdType> (chain.size()), chain.data());
  }
  if (cells->GetNumberOfCells() == 0)
    return nullptr;
  const auto data = vertices.polyData();
  data->SetLines (cells);
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData (data);
  if (behind) { // as above, by less
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyLineOffsetParameters (0.0, kLineOffset);
  }
  auto actor = actorOf (mapper, false);
  actor->GetProperty()->SetLineWidth (static_cast<float> (pixels));
  return actor;
}

} // namespace pcl_msf::visualization
