// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/io/figures.h>
#include <pcl_msf/io/float_files.h>
#include <pcl_msf/io/images.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

bool
isKnown (const cv::Vec2f& flow)
{
  return std::isfinite (flow[0]) && std::isfinite (flow[1]);
}

/** End-point errors over the pixels of a mask (or all) where the truth is known. */
void
printErrors (const char* name,
             const cv::Mat& flow,
             const cv::Mat& truth,
             const cv::Mat& mask)
{
  std::vector<float> errors;
  int asked = 0;
  for (int v = 0; v < truth.rows; ++v)
    for (int u = 0; u < truth.cols; ++u) {
      const auto& expected = truth.at<cv::Vec2f> (v, u);
      const auto& found = flow.at<cv::Vec2f> (v, u);
      if (!isKnown (expected) || (!mask.empty() && mask.at<unsigned char> (v, u) == 0))
        continue;
      ++asked;
      if (isKnown (found))
        errors.push_back (static_cast<float> (cv::norm (found - expected)));
    }
  if (errors.empty()) {
    std::printf ("%-15s no pixel to compare\n", name);
    return;
  }
  std::sort (errors.begin(), errors.end());
  double sum = 0.0;
  for (const float error : errors)
    sum += error;
  const auto n = static_cast<double> (errors.size());
  const auto large = std::upper_bound (errors.begin(), errors.end(), 3.0f);
  std::printf (
      "%-15s mean %7.3f px, median %7.3f px, over 3 px %5.2f %%, known %6.2f %%\n",
      name,
      sum / n,
      errors[errors.size() / 2],
      100.0 * static_cast<double> (errors.end() - large) / n,
      100.0 * n / asked);
}

} // namespace

/** Prints the end-point error of an optical flow against the truth. */
int
main (int argc, char** argv)
{
  if (argc < 3 || argc > 5) {
    std::fprintf (
        stderr, "usage: %s FLOW.flo TRUTH.flo [VISIBLE.png [ERROR.png]]\n", argv[0]);
    return 2;
  }
  try {
    const cv::Mat flow = pcl_msf::io::readFlow (argv[1]);
    const cv::Mat truth = pcl_msf::io::readFlow (argv[2]);
    if (flow.size() != truth.size())
      throw std::runtime_error ("the two flows differ in size");
    printErrors ("all points", flow, truth, {});
    if (argc >= 4) {
      const cv::Mat visible = pcl_msf::io::readMask (argv[3]);
      if (visible.size() != truth.size())
        throw std::runtime_error (std::string (argv[3]) + ": no image of that size");
      printErrors ("visible points", flow, truth, visible);
    }
    if (argc == 5)
      pcl_msf::io::writeImage (
          argv[4],
          pcl_msf::io::scalarPicture (pcl_msf::io::flowError (flow, truth), 0.0, "px"));
  }
  catch (const std::exception& error) {
    std::fprintf (stderr, "%s: %s\n", argv[0], error.what());
    return 1;
  }
  return 0;
}
