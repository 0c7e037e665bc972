// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "visualization/vtk_actors.h"

#include <vtkArrowSource.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3D.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <pcl_msf/errors.h>

#include <cmath>

namespace pcl_msf::visualization {

namespace {

constexpr double kOffset = 4000.0; ///< of depth, in 2^-16 of its range

bool
isFinite (const cv::Vec3f& p)
{
  return std::isfinite (p[0]) && std::isfinite (p[1]) && std::isfinite (p[2]);
}

/** Points and their colours as VTK has them. */
class Vertices {
public:
  Vertices() { colors_->SetNumberOfComponents (3); }

  vtkIdType
  add (const cv::Vec3f& p, const cv::Vec3b& bgr)
  {
    const unsigned char rgb[] = {bgr[2], bgr[1], bgr[0]};
    colors_->InsertNextTypedTuple (rgb);
    return points_->InsertNextPoint (p[0], p[1], p[2]);
  }
  vtkIdType
  size () const
  {
    return points_->GetNumberOfPoints();
  }
  vtkSmartPointer<vtkPolyData>
  polyData () const
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints (points_);
    data->GetPointData()->SetScalars (colors_);
    return data;
  }

private:
  vtkSmartPointer<vtkPoints> points_ = vtkSmartPointer<vtkPoints>::New();
  vtkSmartPointer<vtkUnsignedCharArray> colors_ =
      vtkSmartPointer<vtkUnsignedCharArray>::New();
};

vtkSmartPointer<vtkActor>
actorOf (vtkPolyDataMapper* mapper, bool lit)
{
  mapper->SetColorModeToDirectScalars();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper (mapper);
  actor->GetProperty()->SetLighting (lit);
  return actor;
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
  for (int row = 0; row < set.positions.rows; ++row)
    for (int col = 0; col < set.positions.cols; ++col) {
      const auto& p = set.positions.at<cv::Vec3f> (row, col);
      if (isFinite (p))
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
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData (data);
  if (behind) { // what lies on the cloud is drawn over it
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyPointOffsetParameter (kOffset);
  }
  auto actor = actorOf (mapper, false);
  actor->GetProperty()->SetPointSize (static_cast<float> (pixels));
  return actor;
}

vtkSmartPointer<vtkActor>
arrowActor (const std::vector<Arrow>& arrows)
{
  Vertices vertices;
  auto directions = vtkSmartPointer<vtkFloatArray>::New();
  directions->SetNumberOfComponents (3);
  directions->SetName ("direction");
  for (const Arrow& arrow : arrows) {
    const cv::Vec3f d = arrow.to - arrow.from;
    if (!isFinite (arrow.from) || !isFinite (d))
      continue;
    vertices.add (arrow.from, arrow.color);
    directions->InsertNextTypedTuple (d.val);
  }
  if (vertices.size() == 0)
    return nullptr;
  const auto data = vertices.polyData();
  data->GetPointData()->AddArray (directions);
  data->GetPointData()->SetActiveVectors ("direction");
  auto shape = vtkSmartPointer<vtkArrowSource>::New();
  shape->SetTipResolution (12);
  shape->SetShaftResolution (8);
  shape->SetShaftRadius (0.06);
  shape->SetTipRadius (0.2);
  shape->SetTipLength (0.42);
  auto glyphs = vtkSmartPointer<vtkGlyph3D>::New();
  glyphs->SetInputData (data);
  glyphs->SetSourceConnection (shape->GetOutputPort());
  glyphs->SetVectorModeToUseVector();
  glyphs->SetScaleModeToScaleByVector();
  glyphs->SetColorModeToColorByScalar();
  glyphs->OrientOn();
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputConnection (glyphs->GetOutputPort());
  auto actor = actorOf (mapper, true);
  actor->GetProperty()->SetAmbient (0.45);
  actor->GetProperty()->SetDiffuse (0.55);
  return actor;
}

vtkSmartPointer<vtkActor>
lineActor (const std::vector<Polyline>& lines, double pixels)
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
  auto actor = actorOf (mapper, false);
  actor->GetProperty()->SetLineWidth (static_cast<float> (pixels));
  return actor;
}

} // namespace pcl_msf::visualization
