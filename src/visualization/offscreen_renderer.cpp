// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderer.h>
#include <vtkRenderingOpenGLConfigure.h>
#include <vtkRenderWindow.h>
#include <vtkWindowToImageFilter.h>

#include <opencv2/imgproc.hpp>

#include "visualization/annotations.h"
#include "visualization/base/vtk_actors.h"
#include "visualization/layer_sum.h"
#include "visualization/point_size.h"
#include "visualization/projection.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/visualization/offscreen_renderer.h>
#include <pcl_msf/visualization/virtual_display.h>

#include <algorithm>
#include <cmath>
#include <vector>

#ifdef VTK_OPENGL_HAS_EGL
#include <vtkEGLRenderWindow.h>
#endif

namespace pcl_msf::visualization {

namespace {

constexpr int kLargestSide = 16384; ///< of OpenGL's textures, at least
constexpr double kLineWidth = 1.5;  ///< of trajectories, pixels at 480 rows
constexpr double kCasing = 1.9;     ///< width of the dark line below one, line widths
const cv::Vec3b kCasingColor (60, 60, 60);

/** A window that needs no display where VTK has one (EGL; OSMesa is its default). */
vtkSmartPointer<vtkRenderWindow>
makeWindow ()
{
#ifdef VTK_OPENGL_HAS_EGL
  return vtkSmartPointer<vtkEGLRenderWindow>::New();
#else
  return vtkSmartPointer<vtkRenderWindow>::New();
#endif
}

/** The same lines in one dark colour: bright ones stand out on it from any ground. */
std::vector<Polyline>
darkened (std::vector<Polyline> lines)
{
  for (Polyline& line : lines)
    line.colors.assign (line.points.size(), kCasingColor);
  return lines;
}

void
setCamera (vtkCamera& camera, const View& view, const DepthRange& range)
{
  const Eigen::Vector3d forward = view.rotation.row (2);
  const Eigen::Vector3d up = -view.rotation.row (1);
  const Eigen::Vector3d focus = view.position + forward;
  camera.SetPosition (view.position.x(), view.position.y(), view.position.z());
  camera.SetFocalPoint (focus.x(), focus.y(), focus.z());
  camera.SetViewUp (up.x(), up.y(), up.z());
  camera.SetParallelProjection (view.parallel);
  camera.SetClippingRange (range.near, range.far);
  const Eigen::Matrix4d m = projectionMatrix (view, range);
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int row = 0; row < 4; ++row)
    for (int col = 0; col < 4; ++col)
      matrix->SetElement (row, col, m (row, col));
  camera.SetExplicitProjectionTransformMatrix (matrix);
  camera.UseExplicitProjectionTransformMatrixOn();
}

void
requireView (const View& view)
{
  std::string why;
  if (view.size.empty())
    throw InvalidInput ("view: it has no size");
  if (view.parallel ? !(view.scale > 0.0) || !std::isfinite (view.scale)
                    : !view.camera.isValid (view.size.width, view.size.height, &why))
    throw InvalidInput ("view: " + (view.parallel ? "scale must be > 0" : why));
  if (!view.rotation.allFinite() || !view.position.allFinite())
    throw InvalidInput ("view: its pose is not finite");
}

} // namespace

bool
PictureStyle::isValid (std::string* why) const
{
  std::string problem;
  if (size.width < 16 || size.height < 16 || size.width > 3840 || size.height > 2160)
    problem = "size: must be 16x16 to 3840x2160 pixels";
  else if (supersampling < 1 || supersampling > 8)
    problem = "supersampling: must be 1 to 8";
  else if (supersampling * std::max (size.width, size.height) > kLargestSide)
    problem = "supersampling: size times supersampling must not exceed 16384 pixels";
  else if (!(point_size >= 0.0 && point_size <= 100.0))
    problem = "point_size: must be 0 (automatic) to 100 pixels";
  if (why != nullptr)
    *why = problem;
  return problem.empty();
}

/** The VTK window; the display outlives it. */
class OffscreenRenderer::Window {
public:
  Window()
  {
    window_->SetOffScreenRendering (1);
    window_->SetMultiSamples (0); // supersampling does it, the same on every machine
    window_->AddRenderer (renderer_);
  }

  cv::Mat
  draw (const Scene& scene, const View& view, const PictureStyle& style)
  {
    const DepthRange range = depthRange (scene, view);
    if (!scene.blended || scene.points.size() < 2) {
      cv::Mat picture;
      cv::cvtColor (layer (scene, view, range, style), picture, cv::COLOR_BGRA2BGR);
      return picture;
    }
    LayerSum sum (style.background);
    for (const PointSet& set : scene.points) {
      Scene alone;
      alone.points = {set};
      alone.arrows = scene.arrows;
      alone.lines = scene.lines;
      sum.add (layer (alone, view, range, style));
    }
    return sum.mean();
  }

private:
  /** A scene as drawn: CV_8UC4 (BGRA, the background's alpha is 0). */
  cv::Mat
  layer (const Scene& scene,
         const View& view,
         const DepthRange& range,
         const PictureStyle& style)
  {
    const int factor = style.supersampling;
    renderer_->RemoveAllViewProps();
    const double line = kLineWidth * std::max (1.0, style.size.height / 480.0) * factor;
    const bool has_marks = !scene.arrows.empty() || !scene.lines.empty();
    for (const PointSet& set : scene.points)
      add (pointActor (set, factor * pointSize (set, view, style), has_marks));
    add (lineActor (darkened (scene.lines), kCasing * line, true));
    add (lineActor (scene.lines, line, false));
    add (arrowActor (scene.arrows));
    const cv::Vec3b& b = style.background;
    renderer_->SetBackground (b[2] / 255.0, b[1] / 255.0, b[0] / 255.0);
    setCamera (*renderer_->GetActiveCamera(), view, range);
    window_->SetSize (factor * style.size.width, factor * style.size.height);
    window_->Render();
    return grab (style.size);
  }

  void
  add (vtkActor* actor)
  {
    if (actor != nullptr)
      renderer_->AddActor (actor);
  }

  cv::Mat
  grab (const cv::Size& size)
  {
    auto filter = vtkSmartPointer<vtkWindowToImageFilter>::New();
    filter->SetInput (window_);
    filter->ReadFrontBufferOff();
    filter->ShouldRerenderOff();
    filter->SetInputBufferTypeToRGBA();
    filter->Update();
    vtkImageData* image = filter->GetOutput();
    const int* drawn = image->GetDimensions();
    if (drawn[0] < size.width || drawn[1] < size.height ||
        image->GetScalarPointer() == nullptr)
      throw DisplayError ("OpenGL gave no picture; try a smaller one");
    const cv::Mat rgba (drawn[1], drawn[0], CV_8UC4, image->GetScalarPointer());
    cv::Mat result;
    cv::resize (rgba, result, size, 0.0, 0.0, cv::INTER_AREA);
    cv::flip (result, result, 0);
    cv::cvtColor (result, result, cv::COLOR_RGBA2BGRA);
    return result;
  }

  VirtualDisplay display_;
  vtkSmartPointer<vtkRenderWindow> window_ = makeWindow();
  vtkSmartPointer<vtkRenderer> renderer_ = vtkSmartPointer<vtkRenderer>::New();
};

OffscreenRenderer::OffscreenRenderer() : window_ (std::make_unique<Window>()) {}

OffscreenRenderer::~OffscreenRenderer() = default;

cv::Mat
OffscreenRenderer::render (const Scene& scene,
                           const View& view,
                           const PictureStyle& style)
{
  std::string why;
  if (!style.isValid (&why))
    throw InvalidInput (why);
  requireView (view);
  const View fitted = view.resized (style.size);
  cv::Mat picture = window_->draw (scene, fitted, style);
  annotate (picture, scene, fitted, style);
  return picture;
}

} // namespace pcl_msf::visualization
