// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgproc.hpp>

#include "io/figure_parts.h"
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

const std::array<Curve, 5> kCurves{
    {{"total", {0, 0, 0}, [] (const IterationRecord& r) { return r.cost; }},
     {"brightness",
      {30, 120, 240},
      [] (const IterationRecord& r) { return r.terms.brightness; }},
     {"icp", {200, 110, 20}, [] (const IterationRecord& r) { return r.terms.icp; }},
     {"regularizer",
      {60, 150, 40},
      [] (const IterationRecord& r) { return r.terms.regularizer; }},
     {"prior", {170, 60, 160}, [] (const IterationRecord& r) {
        return r.terms.prior;
      }}}};

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
        if (!(value > 0.0) || !std::isfinite (value))
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
  int
  row (double value) const
  {
    const double decade =
        value > 0.0 ? std::clamp (std::log10 (value), low_, high_) : low_;
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

/** Bands for the levels; the coarsest comes first. */
void
drawLevels (cv::Mat& plot,
            const cv::Rect& area,
            const Axes& axes,
            const std::vector<IterationRecord>& history,
            int letters)
{
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= history.size(); ++i) {
    if (i < history.size() && history[i].level == history[begin].level)
      continue;
    const int left = axes.column (static_cast<double> (begin));
    const int right = axes.column (static_cast<double> (i));
    if (history[begin].level % 2 != 0)
      cv::rectangle (plot,
                     cv::Rect (left, area.y, right - left, area.height),
                     cv::Scalar::all (236),
                     cv::FILLED);
    const std::string words = "level " + std::to_string (history[begin].level);
    if (textWidth (words, letters) < right - left)
      drawText (plot,
                words,
                {left + letters / 2, area.y + 3 * letters / 2},
                letters,
                cv::Scalar::all (90));
    begin = i;
  }
}

void
drawCurves (cv::Mat& plot,
            const Axes& axes,
            const std::vector<IterationRecord>& history)
{
  for (std::size_t c = kCurves.size(); c-- > 0;) {
    cv::Point last;
    for (std::size_t i = 0; i < history.size(); ++i) {
      const double value = kCurves[c].value (history[i]);
      const cv::Point at (axes.column (static_cast<double> (i) + 0.5),
                          axes.row (value));
      cv::circle (plot, at, 2 * kDetail, kCurves[c].color, cv::FILLED, cv::LINE_AA);
      // Levels have energies of their own: no line leads from one to the next.
      if (i > 0 && history[i].level == history[i - 1].level)
        cv::line (plot, last, at, kCurves[c].color, 3 * kDetail / 2, cv::LINE_AA);
      last = at;
    }
  }
}

void
drawNames (cv::Mat& plot, const cv::Rect& area, int letters)
{
  int x = area.x;
  const int base = plot.rows - letters;
  for (const Curve& curve : kCurves) {
    cv::line (plot,
              {x, base - letters / 2},
              {x + 2 * letters, base - letters / 2},
              curve.color,
              2 * kDetail,
              cv::LINE_AA);
    x += 5 * letters / 2;
    x += drawText (plot, curve.name, {x, base}, letters, cv::Scalar::all (0)) + letters;
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
      5 * letters, 2 * letters, plot.cols - 6 * letters, plot.rows - 7 * letters);
  const Axes axes (report.history, area);
  drawLevels (plot, area, axes, report.history, letters);
  drawGrid (plot, area, axes, letters);
  drawCurves (plot, axes, report.history);
  const std::string words =
      "cost; " + std::to_string (report.history.size()) + " iterations, coarse to fine";
  drawText (
      plot, words, {area.x, area.br().y + 2 * letters}, letters, cv::Scalar::all (0));
  drawNames (plot, area, letters);
  cv::Mat result;
  cv::resize (plot, result, size, 0.0, 0.0, cv::INTER_AREA);
  return result;
}

} // namespace pcl_msf::io
