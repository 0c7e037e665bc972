// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/segments/surface_links.h"

#include "core/segments/surface_clusters.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace pcl_msf {

namespace {

/** A common border, in pairs of pixels. */
struct Border {
  int length{0};
  int smooth{0};
};

class Borders {
public:
  Borders (const cv::Mat& labels,
           const FrameLevel& level,
           double noise,
           const SegmentTuning& tuning,
           const std::vector<SegmentLink>& links);

  void
  measure ();

  double
  strength (std::size_t link) const
  {
    const Border& b = borders_[link];
    const double share = b.length > 0 ? static_cast<double> (b.smooth) / b.length : 0.0;
    return tuning_.links.apart + (1.0 - tuning_.links.apart) * share;
  }

private:
  void
  add (int x0, int y0, int x1, int y1);

  const cv::Mat& labels_;
  const cv::Mat& inverse_depth_;
  const float noise_;
  const SegmentTuning& tuning_;
  std::vector<std::vector<std::pair<int, std::size_t>>> links_of_; ///< by the first
  std::vector<Border> borders_;                                    ///< per link
};

Borders::Borders (const cv::Mat& labels,
                  const FrameLevel& level,
                  double noise,
                  const SegmentTuning& tuning,
                  const std::vector<SegmentLink>& links)
: labels_ (labels)
, inverse_depth_ (level.inverse_depth)
, noise_ (static_cast<float> (noise))
, tuning_ (tuning)
, borders_ (links.size())
{
  int segments = 0;
  for (const SegmentLink& link : links)
    segments = std::max (segments, link.second + 1);
  links_of_.resize (segments);
  for (std::size_t i = 0; i < links.size(); ++i)
    links_of_[links[i].first].emplace_back (links[i].second, i);
}

void
Borders::add (int x0, int y0, int x1, int y1)
{
  const int a = labels_.at<std::int32_t> (y0, x0);
  const int b = labels_.at<std::int32_t> (y1, x1);
  const int first = std::min (a, b);
  if (a == b || first < 0 || first >= static_cast<int> (links_of_.size()))
    return;
  const float w0 = inverse_depth_.at<float> (y0, x0);
  const float w1 = inverse_depth_.at<float> (y1, x1);
  if (!(w0 > 0.0f && w1 > 0.0f))
    return;
  const float step =
      tuning_.links.step * surfaceTolerance (std::min (w0, w1), noise_, tuning_);
  for (const auto& [second, link] : links_of_[first])
    if (second == std::max (a, b)) {
      ++borders_[link].length;
      borders_[link].smooth += std::abs (w0 - w1) < step ? 1 : 0;
    }
}

void
Borders::measure()
{
  for (int y = 0; y < labels_.rows; ++y)
    for (int x = 0; x < labels_.cols; ++x) {
      if (x + 1 < labels_.cols)
        add (x, y, x + 1, y);
      if (y + 1 < labels_.rows)
        add (x, y, x, y + 1);
    }
}

} // namespace

void
weighLinksBySurface (const cv::Mat& labels,
                     const FrameLevel& level,
                     double inverse_depth_noise,
                     const SegmentTuning& tuning,
                     std::vector<SegmentLink>& links)
{
  Borders borders (labels, level, inverse_depth_noise, tuning, links);
  borders.measure();
  double sum = 0.0;
  for (std::size_t i = 0; i < links.size(); ++i)
    sum += links[i].strength = borders.strength (i);
  for (SegmentLink& link : links)
    link.strength *= static_cast<double> (links.size()) / sum;
}

} // namespace pcl_msf
