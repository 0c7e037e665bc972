// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <vtkActor.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <opencv2/core.hpp>

#include <cmath>

namespace pcl_msf::visualization {

inline bool
isFinite (const cv::Vec3f& p)
{
  return std::isfinite (p[0]) && std::isfinite (p[1]) && std::isfinite (p[2]);
}

/** \brief Points and their colours as VTK has them. */
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

/** \brief An actor that shows colours as they are. */
inline vtkSmartPointer<vtkActor>
actorOf (vtkPolyDataMapper* mapper, bool lit)
{
  mapper->SetColorModeToDirectScalars();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper (mapper);
  actor->GetProperty()->SetLighting (lit);
  return actor;
}

} // namespace pcl_msf::visualization
