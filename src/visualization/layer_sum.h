// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

namespace pcl_msf::visualization {

/** \brief Averages pictures of parts of a scene, each where it is drawn. */
class LayerSum {
public:
  explicit LayerSum (const cv::Vec3b& background) : background_ (background) {}

  /** \param layer CV_8UC4 (BGRA) over the background, whose alpha is 0; all of one size
   */
  void
  add (const cv::Mat& layer);

  /** \brief The mean of the layers' colours over the background, CV_8UC3. */
  cv::Mat
  mean () const;

private:
  cv::Vec3b background_;
  cv::Mat color_;    ///< CV_32FC3, sum of the layers' own colours times their alpha
  cv::Mat coverage_; ///< CV_32FC2, sum and largest of the layers' alpha
};

} // namespace pcl_msf::visualization
