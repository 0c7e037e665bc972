// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "visualization/annotations.h"

#include <opencv2/imgproc.hpp>

#include "io/base/drawing.h"
#include "visualization/text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_msf::visualization {

namespace {

/** Where and in which colours things are drawn on one picture. */
class Canvas {
public:
  Canvas (cv::Mat& picture, const PictureStyle& style) : picture_ (picture)
  {
    const cv::Vec3b& b = style.background;
    const bool dark = 0.114 * b[0] + 0.587 * b[1] + 0.299 * b[2] < 128.0;
    ink_ = cv::Scalar::all (dark ? 240 : 20);
    paper_ = cv::Scalar (b[0], b[1], b[2]);
    line_ = std::max (10, cvRound (std::min (picture.rows, picture.cols) / 27.0));
  }
  int
  line () const
  {
    return line_;
  }
  int
  margin () const
  {
    return line_ / 2;
  }
  cv::Mat&
  picture ()
  {
    return picture_;
  }
  const cv::Scalar&
  ink () const
  {
    return ink_;
  }
  /** Lets the background shine through a box so that letters can be read on it. */
  void
  box (const cv::Rect& wanted)
  {
    const cv::Rect place = wanted & cv::Rect (0, 0, picture_.cols, picture_.rows);
    if (place.empty())
      return;
    cv::Mat part = picture_ (place);
    const cv::Mat plain (part.size(), part.type(), paper_);
    cv::addWeighted (part, 0.2, plain, 0.8, 0.0, part);
  }
  int
  text (const std::string& words, const cv::Point& corner, bool bold = false)
  {
    return drawLine (picture_, words, corner, line_, ink_, bold);
  }
  int
  width (const std::string& words, bool bold = false) const
  {
    return textMask (words, line_, bold).cols;
  }

private:
  cv::Mat& picture_;
  cv::Scalar ink_;
  cv::Scalar paper_;
  int line_{0};
};

void
drawTitleAndLegend (Canvas& canvas, const Scene& scene, const PictureStyle& style)
{
  const bool title = style.title && !scene.title.empty();
  const std::size_t entries = style.legend ? scene.legend.size() : 0;
  if (!title && entries == 0)
    return;
  const int swatch = canvas.line() * 6 / 10;
  int width = title ? canvas.width (scene.title, true) : 0;
  for (std::size_t i = 0; i < entries; ++i)
    width = std::max (width, canvas.width (scene.legend[i].text) + canvas.line());
  const int rows = static_cast<int> (entries) + (title ? 1 : 0);
  canvas.box (
      {0, 0, width + 2 * canvas.margin(), rows * canvas.line() + canvas.margin()});
  cv::Point at (canvas.margin(), canvas.margin() / 2);
  if (title) {
    canvas.text (scene.title, at, true);
    at.y += canvas.line();
  }
  for (std::size_t i = 0; i < entries; ++i, at.y += canvas.line()) {
    const cv::Point corner = at + cv::Point (0, (canvas.line() - swatch) / 2);
    cv::rectangle (canvas.picture(),
                   cv::Rect (corner, cv::Size (swatch, swatch)),
                   cv::Scalar (scene.legend[i].color),
                   cv::FILLED);
    canvas.text (scene.legend[i].text, at + cv::Point (canvas.line(), 0));
  }
}

void
drawScale (Canvas& canvas, const ColorScale& scale)
{
  const int width = std::max (6 * canvas.line(), canvas.width (scale.title));
  const int bar = canvas.line() / 2;
  const int height = 2 * canvas.line() + bar;
  const cv::Size whole (width + 2 * canvas.margin(), height + canvas.margin());
  const cv::Point corner (canvas.picture().cols - whole.width,
                          canvas.picture().rows - whole.height);
  canvas.box ({corner, whole});
  cv::Mat ramp (bar, width, CV_8UC1);
  for (int col = 0; col < width; ++col)
    ramp.col (col).setTo (255 * col / std::max (1, width - 1));
  cv::Mat colors;
  cv::applyColorMap (ramp, colors, scale.color_map);
  const cv::Point left = corner + cv::Point (canvas.margin(), canvas.margin() / 2);
  canvas.text (scale.title, left);
  const cv::Rect place (left + cv::Point (0, canvas.line()), colors.size());
  if ((place & cv::Rect ({}, canvas.picture().size())) == place)
    colors.copyTo (canvas.picture() (place));
  const int below = left.y + canvas.line() + bar;
  canvas.text (io::shortNumber (scale.minimum), {left.x, below});
  const std::string high =
      (scale.open ? "\u2265 " : "") + io::shortNumber (scale.maximum);
  canvas.text (high, {left.x + width - canvas.width (high), below});
}

/** One of the scene's directions as the view sees it. */
struct Axis {
  Eigen::Vector3d direction;
  const char* name;
  cv::Scalar color;
};

/** x, y and z, nearest last. */
std::array<Axis, 3>
sortedAxes (const View& view)
{
  std::array<Axis, 3> axes{{{view.rotation.col (0), "x", {40, 40, 210}},
                            {view.rotation.col (1), "y", {40, 150, 30}},
                            {view.rotation.col (2), "z", {210, 90, 20}}}};
  std::sort (axes.begin(), axes.end(), [] (const Axis& a, const Axis& b) {
    return a.direction.z() > b.direction.z();
  });
  return axes;
}

/** Draws the directions in the lower left corner. \return the width that they take */
int
drawAxes (Canvas& canvas, const View& view)
{
  const std::array<Axis, 3> axes = sortedAxes (view);
  const double length = 1.4 * canvas.line();
  const double reach = 1.3 * length; // from the origin to the middle of a letter
  cv::Point2d low, high;
  for (const Axis& axis : axes) {
    low.x = std::min (low.x, reach * axis.direction.x());
    low.y = std::min (low.y, reach * axis.direction.y());
    high.x = std::max (high.x, reach * axis.direction.x());
    high.y = std::max (high.y, reach * axis.direction.y());
  }
  const double half = 0.5 * canvas.line();
  const cv::Point2d origin (canvas.margin() + half - low.x,
                            canvas.picture().rows - half - high.y);
  const int width = cvRound (origin.x + high.x + half) + canvas.margin() / 2;
  const int top = cvRound (origin.y + low.y - half);
  canvas.box (cv::Rect (0, top, width, canvas.picture().rows - top));
  constexpr int kShift = 4; // cv draws between pixels with this many bits
  const auto fixed = [] (const cv::Point2d& p) {
    return cv::Point (cvRound (p.x * (1 << kShift)), cvRound (p.y * (1 << kShift)));
  };
  for (const Axis& axis : axes) {
    const cv::Point2d d (axis.direction.x(), axis.direction.y());
    cv::line (canvas.picture(),
              fixed (origin),
              fixed (origin + length * d),
              axis.color,
              std::max (1, canvas.line() / 8),
              cv::LINE_AA,
              kShift);
    const cv::Point2d middle = origin + reach * d;
    const cv::Point corner (cvRound (middle.x) - canvas.width (axis.name) / 2,
                            cvRound (middle.y - half));
    if (cv::norm (d) > 0.25)
      drawLine (canvas.picture(), axis.name, corner, canvas.line(), axis.color, true);
  }
  return width;
}

/** A length in metres; only a parallel view has one for all depths. */
void
drawLength (Canvas& canvas, const View& view, int left)
{
  const double metres = roundLength (0.2 * canvas.picture().cols / view.scale);
  const int width = cvRound (metres * view.scale);
  const std::string words = io::shortNumber (metres) + " m";
  const int thick = std::max (2, canvas.line() / 6);
  const int top = canvas.picture().rows - canvas.line() - thick - canvas.margin();
  const int wide = std::max (width, canvas.width (words));
  canvas.box ({left,
               top - canvas.margin() / 2,
               wide + 2 * canvas.margin(),
               canvas.picture().rows - top});
  canvas.text (words, {left + canvas.margin(), top});
  cv::rectangle (canvas.picture(),
                 cv::Rect (left + canvas.margin(), top + canvas.line(), width, thick),
                 canvas.ink(),
                 cv::FILLED);
}

} // namespace

double
roundLength (double limit)
{
  const double power = std::pow (10.0, std::floor (std::log10 (limit)));
  for (const double step : {5.0, 2.0})
    if (step * power <= limit)
      return step * power;
  return power;
}

void
annotate (cv::Mat& picture,
          const Scene& scene,
          const View& view,
          const PictureStyle& style)
{
  Canvas canvas (picture, style);
  drawTitleAndLegend (canvas, scene, style);
  if (style.legend && scene.scale)
    drawScale (canvas, *scene.scale);
  if (!style.axes)
    return;
  const int width = drawAxes (canvas, view);
  if (view.parallel && view.scale > 0.0)
    drawLength (canvas, view, width);
}

} // namespace pcl_msf::visualization
