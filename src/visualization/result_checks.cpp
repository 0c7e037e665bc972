// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "visualization/result_checks.h"

#include <pcl_msf/errors.h>

namespace pcl_msf::visualization {

namespace {

void
requireImage (const char* name, const cv::Mat& image, int type, const cv::Size& size)
{
  if (image.type() != type || image.size() != size)
    throw InvalidInput (std::string ("result: ") + name +
                        " is missing, of another type or size");
}

void
requireColor (const char* name, const cv::Mat& image, const cv::Size& size)
{
  if (image.empty())
    return;
  if (image.size() != size || (image.type() != CV_8UC1 && image.type() != CV_8UC3))
    throw InvalidInput (std::string ("result: ") + name +
                        " must be 8-bit grey or BGR and of the points' size");
}

} // namespace

void
requireResult (const ResultClouds& result)
{
  const SceneFlow& flow = result.scene_flow;
  const cv::Size size = flow.points.size();
  if (size.empty())
    throw InvalidInput ("result: it holds no points");
  requireImage ("points", flow.points, CV_32FC3, size);
  requireImage ("displacement", flow.displacement, CV_32FC3, size);
  requireImage ("labels", flow.labels, CV_32SC1, size);
  requireImage ("visibility", flow.visibility, CV_8UC1, size);
  requireColor ("reference colour", result.reference_color, size);
  requireColor ("current colour", result.current_color, size);
  if (!result.current_points.empty())
    requireImage ("current points", result.current_points, CV_32FC3, size);
}

void
requireDisplacements (const ResultClouds& result,
                      const std::vector<cv::Mat>& displacements)
{
  if (displacements.empty())
    throw InvalidInput (
        "result: a window needs the displacement of one frame at least");
  for (const cv::Mat& displacement : displacements)
    requireImage ("a displacement of the window",
                  displacement,
                  CV_32FC3,
                  result.scene_flow.points.size());
}

void
requireCurrent (const ResultClouds& result)
{
  if (result.current_points.empty())
    throw InvalidInput ("result: this picture needs the current frame, too; give it");
}

} // namespace pcl_msf::visualization
