// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgproc.hpp>

#include "core/base/opencv_threads.h"
#include "io/base/drawing.h"
#include <pcl_msf/io/figures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl_msf::io {

namespace {

constexpr int kDetail = 3; ///< drawn so many times larger

/** One line of the plot. */
struct Curve {
  const char* name;
  cv::Scalar color;
  double (*value) (const IterationRecord&);
};

const std::array<Curve, 6> kCurves{
    {{"total", {0, 0, 0}, [] (const IterationRecord& r) { return r.cost; }},
     {"brightness",
      {30, 120, 240},
      [] (const IterationRecord& r) { return r.terms.brightness; }},
     {"icp", {200, 110, 20}, [] (const IterationRecord& r) { return r.terms.icp; }},
     {"regularizer",
      {60, 150, 40},
      [] (const IterationRecord& r) { return r.terms.regularizer; }},
     {"prior", {170, 60, 160}, [] (const IterationRecord& r) { return r.terms.prior; }},
     {"concatenation", {150, 150, 20}, [] (const IterationRecord& r) {
        return r.terms.concatenation;
      }}}};

/** Can it be drawn on a logarithmic axis? */
bool
isDrawable (double value)
{
  return value > 0.0 && std::isfinite (value);
}

/** Does the step minimize the energy that the one before it does? */
bool
continues (const std::vector<IterationRecord>& history, std::size_t i)
{
  return i > 0 && i < history.size() && history[i].level == history[i - 1].level &&
         history[i].energy == history[i - 1].energy;
}

/** The axes: iteration to column, cost to row. */
class Axes {
public:
  Axes (const std::vector<IterationRecord>& history, const cv::Rect& area)
  : area_ (area), count_ (static_cast<int> (history.size()))
  {
    double low = std::numeric_limits<double>::infinity();
    double high = 0.0;
    for (const IterationRecord& record : history)
      for (const Curve& curve : kCurves) {
        const double value = curve.value (record);
        if (!isDrawable (value))
          continue;
        low = std::min (low, value);
        high = std::max (high, value);
      }
    high_ = high > 0.0 ? std::ceil (std::log10 (high)) : 0.0;
    // Four decades at the most: what is smaller is nothing.
    low_ = high > 0.0 ? std::max (std::floor (std::log10 (low)), high_ - 4.0) : -1.0;
    low_ = std::min (low_, high_ - 1.0);
  }
  int
  column (double iteration) const
  {
    return area_.x + cvRound (area_.width * iteration / std::max (1, count_));
  }
  /** Values below the axis lie below the area. */
  int
  row (double value) const
  {
    const double decade = std::max (std::log10 (value), low_ - 1.0);
    return area_.y + cvRound (area_.height * (high_ - decade) / (high_ - low_));
  }
  int
  lowest () const
  {
    return static_cast<int> (low_);
  }
  int
  highest () const
  {
    return static_cast<int> (high_);
  }

private:
  cv::Rect area_;
  int count_;
  double low_{-1.0};
  double high_{0.0};
};

void
drawGrid (cv::Mat& plot, const cv::Rect& area, const Axes& axes, int letters)
{
  for (int decade = axes.lowest(); decade <= axes.highest(); ++decade) {
    const int row = axes.row (std::pow (10.0, decade));
    cv::line (plot, {area.x, row}, {area.br().x, row}, cv::Scalar::all (190), kDetail);
    const std::string words = shortNumber (std::pow (10.0, decade));
    drawText (plot,
              words,
              {area.x - textWidth (words, letters) - letters / 2, row + letters / 2},
              letters,
              cv::Scalar::all (0));
  }
  cv::rectangle (plot, area, cv::Scalar::all (0), kDetail);
}

void
drawDashes (cv::Mat& plot, const cv::Rect& area, int column)
{
  const int dash = area.height / 40;
  for (int row = area.y; row < area.br().y; row += 2 * dash)
    cv::line (plot,
              {column, row},
              {column, std::min (row + dash, area.br().y)},
              cv::Scalar::all (60),
              kDetail);
}

/** Bands for the levels; the coarsest comes first. Dashes where another energy begins
 * within a level. */
void
drawLevels (cv::Mat& plot,
            const cv::Rect& area,
            const Axes& axes,
            const std::vector<IterationRecord>& history,
            int letters)
{
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= history.size(); ++i) {
    if (continues (history, i))
      continue;
    const int left = axes.column (static_cast<double> (begin));
    const int right = axes.column (static_cast<double> (i));
    const int level = history[begin].level;
    const bool again = begin > 0 && history[begin - 1].level == level;
    if (level % 2 != 0)
      cv::rectangle (plot,
                     cv::Rect (left, area.y, right - left, area.height),
                     cv::Scalar::all (236),
                     cv::FILLED);
    if (again)
      drawDashes (plot, area, left);
    const std::string words = again ? "new energy" : "level " + std::to_string (level);
    if (textWidth (words, letters) < right - left)
      drawText (
          plot, words, {left, area.y - letters / 2}, letters, cv::Scalar::all (60));
    begin = i;
  }
}

/** \param plot the area of the axes: what leaves it is cut off */
void
drawCurve (cv::Mat& plot,
           const cv::Point& corner,
           const Axes& axes,
           const std::vector<IterationRecord>& history,
           const Curve& curve)
{
  cv::Point last;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const double value = curve.value (history[i]);
    if (!isDrawable (value))
      continue;
    const cv::Point at =
        cv::Point (axes.column (static_cast<double> (i) + 0.5), axes.row (value)) -
        corner;
    cv::circle (plot, at, 2 * kDetail, curve.color, cv::FILLED, cv::LINE_AA);
    // Energies do not compare: no line leads from one to the next.
    if (continues (history, i) && isDrawable (curve.value (history[i - 1])))
      cv::line (plot, last, at, curve.color, 3 * kDetail / 2, cv::LINE_AA);
    last = at;
  }
}

/** Names of the curves that have a value at all. */
void
drawNames (cv::Mat& plot,
           const cv::Rect& area,
           const std::vector<IterationRecord>& history,
           int letters)
{
  int x = area.x;
  const int base = plot.rows - letters;
  for (const Curve& curve : kCurves) {
    if (std::none_of (
            history.begin(), history.end(), [&curve] (const IterationRecord& r) {
              return isDrawable (curve.value (r));
            }))
      continue;
    cv::line (plot,
              {x, base - letters / 2},
              {x + 3 * letters / 2, base - letters / 2},
              curve.color,
              2 * kDetail,
              cv::LINE_AA);
    x += 2 * letters;
    x += drawText (plot, curve.name, {x, base}, letters, cv::Scalar::all (0)) +
         4 * letters / 5;
  }
}

} // namespace

cv::Mat
convergencePlot (const Report& report, const cv::Size& size)
{
  CV_Assert (size.width >= 160 && size.height >= 120);
  cv::Mat plot (
      kDetail * size.height, kDetail * size.width, CV_8UC3, cv::Scalar::all (255));
  const int letters = std::max (7, size.height / 42) * kDetail;
  const cv::Rect area (
      5 * letters, 2 * letters, plot.cols - 6 * letters, plot.rows - 9 * letters);
  const Axes axes (report.history, area);
  drawLevels (plot, area, axes, report.history, letters);
  drawGrid (plot, area, axes, letters);
  cv::Mat inside = plot (area);
  for (auto curve = kCurves.rbegin(); curve != kCurves.rend(); ++curve)
    drawCurve (inside, area.tl(), axes, report.history, *curve);
  const std::string words =
      "cost; " + std::to_string (report.history.size()) + " iterations, coarse to fine";
  const cv::Scalar black = cv::Scalar::all (0);
  const int below = area.br().y;
  drawText (plot, words, {area.x, below + 2 * letters}, letters, black);
  drawText (plot,
            "costs compare along a line only, not across levels and dashes",
            {area.x, below + 4 * letters},
            letters,
            black);
  drawNames (plot, area, report.history, letters);
  cv::Mat result;
  inThisThread ([&] { cv::resize (plot, result, size, 0.0, 0.0, cv::INTER_AREA); });
  return result;
}

} // namespace pcl_msf::io
