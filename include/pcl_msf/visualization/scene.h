// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/export.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl_msf::visualization {

/** \brief Points with a colour each, and surface between some of them. */
struct PointSet {
  cv::Mat positions;                  ///< CV_32FC3, metres; NaN = no point
  cv::Mat colors;                     ///< CV_8UC3 (BGR), same size
  std::vector<cv::Vec3i> triangles{}; ///< corners as row * columns + column; in between
                                      ///< colours are mixed
};

/** \brief A displacement, drawn as an arrow. Metres. */
struct Arrow {
  cv::Vec3f from;
  cv::Vec3f to;
  cv::Vec3b color;      ///< BGR
  float thickest{1e9F}; ///< arrows grow thicker with their length, up to this one
};

/** \brief A line through points, metres, with a colour (BGR) at each. */
struct Polyline {
  std::vector<cv::Vec3f> points;
  std::vector<cv::Vec3b> colors;
};

struct LegendEntry {
  cv::Vec3b color; ///< BGR
  std::string text;
};

/** \brief A colour map with numbers, drawn as a bar. */
struct ColorScale {
  double minimum{0.0};
  double maximum{1.0};
  std::string title; ///< what it is and its unit, e.g. "displacement [m]"
  int color_map{0};  ///< cv::ColormapTypes
  bool open{false};  ///< some values lie beyond the maximum and have its colour
};

/** \brief What a picture shows. */
struct Scene {
  std::string title;
  std::vector<PointSet> points;
  bool blended{false}; ///< each set is drawn alone and the pictures are averaged, so
                       ///< that of two clouds in one place both are seen
  std::vector<Arrow> arrows;
  std::vector<Polyline> lines;
  std::vector<LegendEntry> legend;
  std::optional<ColorScale> scale;
};

/** \brief How it is drawn. */
struct PCL_MSF_EXPORT PictureStyle {
  cv::Size size{640, 480};             ///< pixels, up to 3840 x 2160
  int supersampling{2};                ///< drawn so many times larger, [1, 8]
  double point_size{0.0};              ///< pixels of the picture; 0 = automatic
  cv::Vec3b background{255, 255, 255}; ///< BGR
  bool axes{true};                     ///< the scene's directions, lower left
  bool legend{true};                   ///< legend and colour scale
  bool title{true};

  /** \brief Can it be drawn? \param[out] why not, and the remedy */
  bool
  isValid (std::string* why = nullptr) const;
};

} // namespace pcl_msf::visualization
